import type { Program } from "../nc/program.ts";
import type { Report } from "./report.ts";

/** A tool as called: by number, with or without an index, or by name. */
export type CalledAs = number | string;

/** Tools named by a finding but not called by the program: a replacement, or a better one. */
const namedIn = (data: object = {}): CalledAs[] => {
  const { tool, otherTool } = data as { readonly tool?: unknown; readonly otherTool?: unknown };
  return [tool, otherTool].filter((each): each is CalledAs => typeof each === "number" || typeof each === "string");
};

/**
 * The tools that programs need to give the same report: all called tools, and all tools named in the report. Null where
 * a call is computed while the program runs.
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
