import type { Spindle } from "../../kernel/time/step.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Program } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import type { Value } from "../../nc/words.ts";
import type { Run } from "../../program/state/run-types.ts";

/** One call of a tool. */
export interface SheetCall {
  readonly index: number;
  readonly called: string;
  /** True for a turning tool: its number is in the turning tool table. */
  readonly turns: boolean;
  /** The tool used after the call; null before a run. */
  readonly ran: Tool | null;
}

export const calledName = (s: Statement): string | null => {
  if (s.kind !== "toolCall" || s.tool === null) return null;
  return typeof s.tool === "object" ? s.tool.parameter : String(s.tool);
};

export const isNamed =
  (called: string) =>
  ({ T, NAME }: { readonly T: number; readonly NAME: string }): boolean =>
    String(T) === called || NAME === called;

/** Whether the tool comes from a parameter, known only while the program runs. */
export const isParameter = (called: string): boolean => /^Q[LRS]?\d+$/.test(called);

/** The spindle speed stated in a tool call. */
export const speedOf = (s: Statement | undefined): Spindle | null =>
  s?.kind === "toolCall" && typeof s.speed === "number" && s.speed > 0 ? { kind: "constant", speed: s.speed } : null;

/**
 * The tool calls of a program in order, each with the tool used after it; tools of called programs where first used.
 */
export function toolCallsOf({ blocks }: Program, run: Run | null, end: number): readonly SheetCall[] {
  const at = blocks.flatMap(({ statement }, index) => {
    const called = index < end ? calledName(statement) : null;
    return called === null ? [] : [{ index, called }];
  });
  const ranIn = (called: string, from: number, to: number): Tool | null => {
    const found = run?.stepBlocks.findIndex((block) => block >= from && block < to) ?? -1;
    const tool = found < 0 ? null : (run?.steps[found]?.tool ?? null);
    // An unknown tool is replaced by another one in the run.
    return tool && (isParameter(called) || isNamed(called)(tool)) ? tool : null;
  };
  const turnsAt = (index: number) => {
    const mode = blocks.slice(0, index).findLast(({ statement }) => statement.kind === "mode")?.statement;
    return mode?.kind === "mode" && mode.mode === "TURN";
  };
  const own = at.map(({ index, called }, i): SheetCall => {
    const ran = ranIn(called, index, at[i + 1]?.index ?? end);
    return { index, called, ran, turns: ran !== null || turnsAt(index) };
  });
  const known = new Set(own.flatMap(({ ran, called }) => [called, ...(ran ? [String(ran.T), ran.NAME] : [])]));
  const others: SheetCall[] = [];
  let before = -1;
  run?.steps.forEach(({ tool, file }, i) => {
    const block = run.stepBlocks[i] ?? end;
    if (block < end) before = block;
    if ((file === undefined && block < end) || known.has(String(tool.T)) || known.has(tool.NAME)) return;
    known.add(String(tool.T));
    others.push({ index: before, called: String(tool.T), ran: tool, turns: true });
  });
  return [...own, ...others].sort((a, b) => a.index - b.index);
}

/** The TOOL DEF data of a tool, where given as numbers. */
export function definedIn(
  { blocks }: Program,
  called: string,
): { readonly length: number | null; readonly radius: number | null } | null {
  const found = blocks.find(({ statement: s }) => s.kind === "toolDefinition" && String(s.tool) === called)?.statement;
  if (found?.kind !== "toolDefinition") return null;
  const known = (value: Value | null) => (typeof value === "number" ? value : null);
  return { length: known(found.length), radius: known(found.radius) };
}
