import type { ThreadFill } from "../../../cycles/thread-values.ts";
import type { SetJob } from "../../../program/job/job.ts";
import type { SetupSizes } from "../../document/edits.ts";
import type { NamedThread } from "../../../kernel/thread/named-thread.ts";
import { threadTool } from "../../../program/tools/thread-tool.ts";
import { newId } from "../../../program/tools/tool-list.ts";
import { addTool } from "../../document/add-tool.ts";
import { listInUse } from "../../document/work-tools.ts";

/** Diameter of the blank of a job that consists of this thread only, mm: its shaft or its bore. */
export const blankOfThread = ({
  inside,
  before,
}: ThreadFill): { readonly place: "outside" | "bore"; readonly size: number } => ({
  place: inside ? "bore" : "outside",
  size: before,
});

/** Sizes of the set-up of that job. A start point on the wrong side of the thread is proposed anew. */
export function setupOfThread({ start }: SetJob, fill: ThreadFill): SetupSizes {
  const { place, size } = blankOfThread(fill);
  const x = Number(start.x);
  const isWrong = fill.inside ? x >= size : x <= size;
  return { blank: { [place]: String(size) }, ...(isWrong && { start: { x: "" } }) };
}

/** Adds a tool with the profile of a thread to the table of the open work, and returns its number. */
export function addThreadTool(thread: NamedThread, fill: ThreadFill): number {
  const list = listInUse();
  const cells = threadTool(list, thread, fill);
  addTool({ id: newId(list), cells });
  return Number(cells.T);
}
