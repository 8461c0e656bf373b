import { shippedList, sameList } from "../../program/tools/tool-list.ts";
import { programOfLines } from "../../course/task-start.ts";
import { openProgram } from "../../app/fields/open/open-program.ts";
import { useTools } from "../../app/document/tool-store.ts";

/**
 * Opens a program of a lesson as a work to experiment with; if the tools of this device differ, it includes the default
 * ones.
 */
export function openLessonExample(lines: readonly string[]): void {
  const text = programOfLines(lines);
  const name = /BEGIN PGM (\S+)/.exec(text)?.[1] ?? "EXAMPLE";
  const isShipped = sameList(useTools.getState().list, shippedList);
  openProgram({ name: `${name}.h`, text, encoding: "utf-8", ...(!isShipped && { tools: shippedList }) });
}
