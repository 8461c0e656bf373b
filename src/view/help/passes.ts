import type { Frame } from "../../kernel/geometry/flat.ts";
import type { Move } from "../../kernel/plan/move.ts";
import type { Plan } from "../../kernel/plan/plan.ts";
import type { Pt, Segment } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { pathOf } from "../../kernel/time/time.ts";
import { outward } from "./frame.ts";
import { drawnLine } from "./section.ts";

/** One cut at one level, or one pass of a cycle along the contour: its start and its end, part space. */
export interface Pass {
  readonly pass: number;
  readonly level: number;
  readonly from: Pt;
  readonly to: Pt;
  /** How the tool runs between the two. */
  readonly line: readonly Pt[];
}

/** Limit of lines; more would be a grey area. */
const MOST = 60;

/** The cuts of roughing. */
export const passesOf = (f: Frame, plan: Plan): Pass[] =>
  (plan.isParallel ? parallels(f, plan.moves) : levels(f, plan.moves)).slice(0, MOST);

/** Step of the manual in which a pass runs along the contour. */
const CUT = 2;

function parallels(f: Frame, moves: readonly Move[]): Pass[] {
  const runs = new Map<number, Segment[]>();
  moves.forEach((m, i) => {
    const from = moves[i - 1]?.to;
    if (!from || m.kind === "rapid" || m.phase !== "rough" || m.pass === undefined || m.step !== CUT) return;
    runs.set(m.pass, [...(runs.get(m.pass) ?? []), pathOf(from, m)]);
  });
  return [...runs].flatMap(([pass, run]) => {
    const line = drawnLine(run);
    const [from, to] = [line[0], line.at(-1)];
    return from && to ? [{ pass, level: outward(f, from), from, to, line }] : [];
  });
}

/** The level part of each pass, at its depth; the ways in and out lie above it. */
function levels(f: Frame, moves: readonly Move[]): Pass[] {
  const level: Pass[] = [];
  const depths = new Map<number, number>();
  moves.forEach((m, i) => {
    const from = moves[i - 1]?.to;
    if (!from || m.kind !== "feed" || m.phase !== "rough" || m.pass === undefined || m.plunging) return;
    const v = outward(f, m.to);
    if (Math.abs(v - outward(f, from)) > SAME) return;
    level.push({ pass: m.pass, level: v, from, to: m.to, line: [from, m.to] });
    depths.set(m.pass, Math.min(v, depths.get(m.pass) ?? v));
  });
  return level.filter((p) => p.level < (depths.get(p.pass) ?? p.level) + SAME);
}

/** The roughing cuts straight into the material, each from its start to its bottom, in machining order. */
export function plungesOf(f: Frame, moves: readonly Move[]): Pass[] {
  const found: Pass[] = [];
  let [begin, last]: [Pt | null, number] = [null, -1];
  moves.forEach((m, i) => {
    const from = moves[i - 1]?.to;
    if (m.kind !== "feed" || m.phase !== "rough" || m.pass === undefined || from === undefined) {
      begin = null;
      return;
    }
    begin ??= from;
    const v = outward(f, m.to);
    const cut: Pass = { pass: m.pass, level: v, from: begin, to: m.to, line: [begin, m.to] };
    const before = found.at(-1);
    if (before === undefined || last < 0 || before.from !== begin) found.push(cut);
    else if (v < before.level) found[found.length - 1] = cut;
    last = i;
  });
  return found.slice(0, MOST);
}
