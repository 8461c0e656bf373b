import { flat, type Flat, type FlatSegment } from "../geometry/flat.ts";
import { positive, signOf } from "../geometry/segments.ts";
import type { Bound } from "./reach.ts";
import { ROUND } from "../tolerance.ts";

const { onCircle, polarOf, radiusOf } = flat;

/**
 * A contour without falling elements: where it falls, a level line runs from the height reached until the contour rises
 * above it again (decision for Q487 = 0). These lines are marked as bridges.
 */
export function bridged(contour: readonly FlatSegment[]): Bound[] {
  const out: Bound[] = [];
  const first = contour[0];
  if (!first) return out;
  let top: Flat = first.from;
  let open = false;
  const close = (to: Flat) => {
    if (open && to.u - top.u > ROUND)
      out.push({ segment: { kind: "line", from: top, to: { u: to.u, v: top.v } }, on: "bridge" });
    open = false;
  };
  for (const s of contour.flatMap(oneWay)) {
    if (s.to.v < s.from.v - ROUND || s.to.v <= top.v - ROUND) {
      open = true;
      continue;
    }
    const from = open ? crossing(s, top.v) : s.from;
    close(from);
    const part: FlatSegment = { ...s, from };
    out.push({ segment: part, on: "contour" });
    top = s.to;
  }
  const last = contour[contour.length - 1] as FlatSegment;
  close(last.to);
  return out.length > 0
    ? out
    : [{ segment: { kind: "line", from: top, to: { u: last.to.u, v: top.v } }, on: "bridge" }];
}

/** Runs of consecutive falling elements of a contour: a tool plunges into them. */
export function fallingRuns(contour: readonly FlatSegment[]): FlatSegment[][] {
  const runs: FlatSegment[][] = [];
  let open = false;
  for (const s of contour.flatMap(oneWay)) {
    const falls = s.to.v < s.from.v - ROUND && s.to.u > s.from.u - ROUND;
    if (falls && open) runs.at(-1)?.push(s);
    else if (falls) runs.push([s]);
    open = falls;
  }
  return runs;
}

/** Splits arcs where they turn from rising to falling, so that each part only rises or only falls. */
function oneWay(s: FlatSegment): FlatSegment[] {
  if (s.kind === "line") return [s];
  const { start, sweep, startRadius } = polarOf(s);
  const way = signOf(s.turn);
  const turns = [Math.PI / 2, -Math.PI / 2]
    .map((a) => positive(way * (a - start)))
    .filter((d) => d > ROUND && d < way * sweep - ROUND);
  const points = [
    s.from,
    ...turns.sort((x, y) => x - y).map((d) => onCircle(s.centre, startRadius, start + way * d)),
    s.to,
  ];
  return points.slice(1).map((to, i): FlatSegment => ({ ...s, from: points[i] as Flat, to }));
}

/** Point where a rising element reaches a height. */
function crossing(s: FlatSegment, v: number): Flat {
  if (s.kind === "line") {
    const k = (v - s.from.v) / (s.to.v - s.from.v || 1);
    return { u: s.from.u + k * (s.to.u - s.from.u), v };
  }
  const h = v - s.centre.v;
  const w = Math.sqrt(Math.max(0, radiusOf(s) ** 2 - h * h));
  const side = (s.from.u + s.to.u) / 2 >= s.centre.u ? 1 : -1;
  return { u: s.centre.u + side * w, v };
}
