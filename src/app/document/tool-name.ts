import { cellOf, type ToolEntry } from "../../program/tools/tool-entry.ts";
import { useTexts } from "../base/settings/use-texts.ts";

/** The label of a row: its number and name, as typed. */
export function useToolName(): (entry: ToolEntry) => string {
  const t = useTexts("tables").tools;
  return (entry) => t.toolName(cellOf(entry, "T").trim() || t.noNumber, cellOf(entry, "NAME").trim());
}
