import type { Program } from "../nc/program.ts";
import type { Report } from "./report.ts";

/** A tool as it is called: by its number, with or without an index, or by its name. */
export type CalledAs = number | string;

/** Tools that a finding names and its program does not call: one that stands in, or one that would do better. */
const namedIn = (data: object = {}): CalledAs[] => {
  const { tool, otherTool } = data as { readonly tool?: unknown; readonly otherTool?: unknown };
  return [tool, otherTool].filter((each): each is CalledAs => typeof each === "number" || typeof each === "string");
};

/**
 * The tools that programs need to come to the same report: all that they call, wherever it is, and all that the report
 * names. Null where that cannot be told, because a call is worked out while the program runs.
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
      ...report.proof.residual.flatMap(({ tools }) => tools),
      ...[...report.issues, ...report.operations.flatMap(({ issues }) => issues)].flatMap(({ data }) => namedIn(data)),
    ]),
  ];
}
