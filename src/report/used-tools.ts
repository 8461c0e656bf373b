import type { Program } from "../nc/program.ts";
import type { Report } from "./report.ts";

/** A tool as called: by number, with or without an index, or by name. */
export type CalledAs = number | string;

/**
 * The tools that programs need for the same path, stock and verdict: all called tools, and those of the operations, one
 * of which may stand in for a missing call. Tools that findings only suggest are left out. Null where a call is computed
 * while the program runs.
 */
export function usedTools(programs: readonly Program[], report: Report): readonly CalledAs[] | null {
  const called = programs.flatMap(({ blocks }) =>
    blocks.flatMap(({ statement }) => (statement.kind === "toolCall" ? [statement.tool] : [])),
  );
  if (called.some((tool) => typeof tool === "object" && tool !== null)) return null;
  return [
    ...new Set([
      ...called.filter((tool) => typeof tool === "number" || typeof tool === "string"),
      ...report.operations.flatMap(({ tool }) => (tool["T"] === undefined ? [] : [tool["T"]])),
    ]),
  ];
}
