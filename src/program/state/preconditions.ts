import type { Cycle } from "../../cycles/define.ts";
import type { Param, Params, Values } from "../../cycles/params.ts";
import type { Move } from "../../kernel/plan/move.ts";
import { feed as feedNumber } from "../../kernel/units.ts";
import { isUnlikely } from "./block-feed.ts";
import { programIssue, type ProgramIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";

/** Reports a block without a tool, unless its TOOL CALL is reported as unusable. */
export function noTool(machine: Machine, index: number): void {
  if (!machine.now.toolRefused) machine.log.report(programIssue("noToolCalled", "error", {}), index);
}

/** Lines of the parameters in a definition, from 0: of the first or second occurrence of each, 0 for none. */
export function linesOfParameters(raw: string): (q: string, time?: number) => number {
  const lines = new Map<string, number[]>();
  raw.split(/\r\n|\n|\r/).forEach((text, line) => {
    for (const [q] of text.matchAll(/(?<![^ \t])Q[LRS]?\d+/gi)) {
      const known = lines.get(q.toUpperCase());
      if (known) known.push(line);
      else lines.set(q.toUpperCase(), [line]);
    }
  });
  return (q, time = 1) => lines.get(q.toUpperCase())?.[time - 1] ?? 0;
}

/** Line of one parameter, from 0. */
export const lineOfParameter = (raw: string, q: string): number => linesOfParameters(raw)(q);

/**
 * Reports parameters that the cycle lacks, and duplicates: a control refuses the former and takes the last of the
 * latter.
 */
export function foreignParameters(machine: Machine, cycle: Cycle, names: readonly string[], index: number): void {
  const lineOf = linesOfParameters(machine.blocks[index]?.raw ?? "");
  const met = new Set<string>();
  for (const q of names) {
    const twice = met.has(q);
    met.add(q);
    if (twice || !(q in cycle.params))
      machine.log.report(
        programIssue("parameterForeign", "warning", { name: q, cycle: cycle.number }, q),
        index,
        lineOf(q, twice ? 2 : 1),
      );
  }
}

const isCut = (m: Move): m is Extract<Move, { kind: "feed" | "arc" }> => m.kind === "feed" || m.kind === "arc";
const standsStill = (moves: readonly Move[]) => moves.filter((m) => isCut(m) && !(m.feed > 0)).length;

/** Implausible feeds of a cycle that its path uses, each at its parameter. */
export function unlikelyFeeds<P extends Params>(
  cycle: Cycle<P>,
  values: Values<P>,
  moves: readonly Move[],
  machine: Machine,
  planned: (values: Values<P>) => readonly Move[],
): ProgramIssue[] {
  const found: ProgramIssue[] = [];
  const names = Object.entries<Param>(cycle.params)
    .filter(([, p]) => p.kind === "feed")
    .map(([q]) => q);
  const read = (q: string) => (values as Readonly<Record<string, number | "auto">>)[q];
  let [still, now] = [standsStill(moves), values];
  for (const q of names) {
    if (still === 0) break;
    const value = read(q);
    if (value === undefined || (value === "auto" ? (machine.now.toolFeed ?? 0) : value) > 0) continue;
    // A parameter is at fault when correcting it and those before it makes more of the path move.
    const mended = { ...now, [q]: feedNumber(1) };
    const left = standsStill(planned(mended));
    if (left >= still) continue;
    [still, now] = [left, mended];
    found.push(programIssue("feedZero", "error", { word: value === "auto" ? "FAUTO" : `${q}=${value}` }, q));
  }
  const run = new Set(moves.filter(isCut).map((m) => m.feed));
  for (const q of names) {
    const value = read(q);
    const feed = value === "auto" ? machine.now.toolFeed : (value ?? null);
    if (feed !== null && run.has(feedNumber(feed)) && isUnlikely(feed, machine.now.perRevolution))
      found.push(programIssue("feedUnlikely", "warning", { feed, unit: machine.feedUnit }, q));
  }
  return found;
}

/** Definitions of turning cycles that no call has run. */
export function reportUncalledCycles(machine: Machine): void {
  const { definitions, called } = machine.state;
  for (const index of definitions.values()) {
    const s = machine.blocks[index]?.statement;
    if (!called.has(index) && s?.kind === "cycle")
      machine.log.report(programIssue("cycleNeverCalled", "warning", { cycle: s.cycle }), index);
  }
}
