import { positive } from "./convex.ts";
import type { Flat, FlatSegment } from "./flat.ts";
import type { Bound } from "./reach.ts";
import { ROUND } from "./tolerance.ts";

/**
 * A contour on which nothing falls: wherever it falls, a level line runs on from the height reached until the contour
 * rises above it again (decision for Q487 = 0). The lines are marked as bridges.
 */
export function bridged(contour: readonly FlatSegment[]): Bound[] {
  const out: Bound[] = [];
  const first = contour[0];
  if (!first) return out;
  let top: Flat = first.from;
  let open = false;
  const close = (to: Flat) => {
    if (open && to.u - top.u > ROUND) out.push({ segment: { kind: "line", from: top, to: { u: to.u, v: top.v } }, on: "bridge" });
    open = false;
  };
  for (const s of contour.flatMap(rising)) {
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
  return out.length > 0 ? out : [{ segment: { kind: "line", from: top, to: { u: last.to.u, v: top.v } }, on: "bridge" }];
}

/** Arcs split where they turn from rising to falling, so that each part only rises or only falls. */
function rising(s: FlatSegment): FlatSegment[] {
  if (s.kind === "line") return [s];
  const r = Math.hypot(s.from.u - s.centre.u, s.from.v - s.centre.v);
  const a0 = Math.atan2(s.from.v - s.centre.v, s.from.u - s.centre.u);
  const a1 = Math.atan2(s.to.v - s.centre.v, s.to.u - s.centre.u);
  const sweep = positive(s.ccw ? a1 - a0 : a0 - a1) || 2 * Math.PI;
  const way = s.ccw ? 1 : -1;
  const cuts = [Math.PI / 2, -Math.PI / 2].map((a) => positive(way * (a - a0))).filter((d) => d > 1e-9 && d < sweep - 1e-9).sort((x, y) => x - y);
  const points = [s.from, ...cuts.map((d): Flat => ({ u: s.centre.u + r * Math.cos(a0 + way * d), v: s.centre.v + r * Math.sin(a0 + way * d) })), s.to];
  return points.slice(1).map((to, i): FlatSegment => ({ ...s, from: points[i] as Flat, to }));
}

/** Where a rising element passes a height. */
function crossing(s: FlatSegment, v: number): Flat {
  if (s.kind === "line") {
    const k = (v - s.from.v) / (s.to.v - s.from.v || 1);
    return { u: s.from.u + k * (s.to.u - s.from.u), v };
  }
  const r = Math.hypot(s.from.u - s.centre.u, s.from.v - s.centre.v);
  const h = v - s.centre.v;
  const w = Math.sqrt(Math.max(0, r * r - h * h));
  const side = (s.from.u + s.to.u) / 2 >= s.centre.u ? 1 : -1;
  return { u: s.centre.u + side * w, v };
}
