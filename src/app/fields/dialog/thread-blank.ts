import type { ThreadFill } from "../../../cycles/thread-values.ts";
import type { NamedThread } from "../../../kernel/thread/named-thread.ts";
import { threadTool } from "../../../program/tools/thread-tool.ts";
import { newId } from "../../../program/tools/tool-list.ts";
import { addTool } from "../../document/add-tool.ts";
import { takePlace } from "../../document/setup-edits.ts";
import { listInUse } from "../../document/work-tools.ts";

/** Diameter of a blank in the set-up of a job. */
export interface SetBlank {
  readonly place: "outside" | "bore";
  readonly text: string;
}

/** Diameter of the blank of a job that consists of this thread only, mm: its shaft or its bore. */
export const blankOfThread = ({
  inside,
  before,
}: ThreadFill): { readonly place: SetBlank["place"]; readonly size: number } => ({
  place: inside ? "bore" : "outside",
  size: before,
});

/** Adds a tool with the profile of a thread to the table of the open work; a job calls it. */
export function addThreadTool(thread: NamedThread, fill: ThreadFill, isJob: boolean): void {
  const list = listInUse();
  const cells = threadTool(list, thread, fill);
  addTool({ id: newId(list), cells });
  if (isJob && cells.T !== undefined) takePlace("tool", cells.T);
}
