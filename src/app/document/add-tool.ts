import type { ToolEntry } from "../../program/tools/tool-entry.ts";
import { bundleOf, setBundle, useEditor } from "./store.ts";
import { editTools } from "./tool-store.ts";
import { onlyBundle } from "./work.ts";
import { listInUse } from "./work-tools.ts";

/** Adds a tool to the table of the open work: its own, or that of this device. */
export function addTool(entry: ToolEntry): void {
  const next = [...listInUse(), entry];
  const bundle = onlyBundle(bundleOf(useEditor.getState()));
  if (bundle.tools) setBundle({ ...bundle, tools: next });
  else editTools(() => next);
}
