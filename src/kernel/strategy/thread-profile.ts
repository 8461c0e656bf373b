import { linePiece, pathAlong, upperEnvelope, type EnvelopePiece, type Origin } from "../reach/envelope.ts";
import { toFlat, type Flat, type FlatSegment, type Frame } from "../geometry/flat.ts";
import { insertOutline } from "../cutter/insert.ts";
import { CHORD, ROUND } from "../tolerance.ts";
import type { Tool } from "../plan/tool.ts";
import { heightOn, type ThreadLine } from "./thread-path.ts";

const TOOTH: Origin = { feature: "nose", on: "contour", corner: false };

/** The lower side of an insert, from left to right, relative to the tip. */
export function lowerSide(tool: Tool, frame: Frame): Flat[] {
  const points = insertOutline(tool, CHORD).map((p) => toFlat(frame, p));
  const lowest = Math.min(...points.map((p) => p.v));
  const sorted = points.filter((p) => Number.isFinite(p.u + p.v)).sort((a, b) => a.u - b.u || a.v - b.v);
  const side: Flat[] = [];
  for (const p of sorted) {
    // Convex: a corner above the line from the previous to the next one belongs to the upper side.
    while (side.length > 1 && turnsUp(side.at(-2) as Flat, side.at(-1) as Flat, p) <= 0) side.pop();
    if (side.length === 0 || p.u - (side.at(-1) as Flat).u > ROUND) side.push(p);
  }
  return side.filter((p) => p.v >= lowest);
}
const turnsUp = (a: Flat, b: Flat, c: Flat) => (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);

/**
 * Tip positions in the plane of the stock when all starts have been cut to the depth: every `pitch`, and the stop
 * position.
 */
export function tipsOf(deepest: readonly Flat[], pitch: number, phase: number): Flat[] {
  const [first, last] = [deepest[0] as Flat, deepest.at(-1) as Flat];
  const count = Math.floor((last.u - first.u) / pitch + 1 + ROUND);
  const places = Array.from({ length: Math.max(0, count) }, (_, k) => first.u + (k + phase) * pitch).filter(
    (u) => u < last.u - ROUND,
  );
  return [...places.map((u) => ({ u, v: heightOn(deepest, u) })), last];
}

/**
 * The finished thread in section, from start to end: the crest, and in it the shape of the insert at every place where
 * its tip crosses the plane.
 */
export function teeth(line: ThreadLine, tips: readonly Flat[], side: readonly Flat[]): FlatSegment[] {
  const [first, last] = [line.crest[0] as Flat, line.crest.at(-1) as Flat];
  const rising = Math.max(
    0,
    ...line.crest.slice(1).map((p, i) => Math.abs(p.v - (line.crest[i] as Flat).v) / (p.u - (line.crest[i] as Flat).u)),
  );
  // Higher up, a flank is above the crest, whatever the taper; comparing the rest of a flank with its neighbours would
  // be wasted.
  const high = Math.min(...side.map((p) => p.v)) + line.depth * (1 + 3 * rising) + rising + 0.01;
  const pieces: EnvelopePiece[] = [];
  const put = (a: Flat, b: Flat) => {
    const piece = linePiece({ u: a.u, v: -a.v }, { u: b.u, v: -b.v }, TOOTH);
    if (piece) pieces.push(piece);
  };
  line.crest.slice(1).forEach((p, i) => put(line.crest[i] as Flat, p));
  const low = upTo(side, high);
  const [left, right] = [low[0]?.u ?? 0, low.at(-1)?.u ?? 0];
  for (const tip of tips)
    if (tip.u + right > first.u && tip.u + left < last.u)
      low.slice(1).forEach((p, i) => {
        const before = low[i] as Flat;
        put({ u: tip.u + before.u, v: tip.v + before.v }, { u: tip.u + p.u, v: tip.v + p.v });
      });
  const up = (p: Flat): Flat => ({ u: p.u, v: -p.v });
  return pathAlong(upperEnvelope(pieces), first.u, last.u).map(({ segment: s }) => ({
    kind: "line",
    from: up(s.from),
    to: up(s.to),
  }));
}

/** The part of a lower side below a height. */
function upTo(side: readonly Flat[], high: number): Flat[] {
  const out: Flat[] = [];
  side.forEach((p, i) => {
    const before = side[i - 1];
    if (before && before.v > high !== p.v > high) {
      const k = (high - before.v) / (p.v - before.v);
      out.push({ u: before.u + k * (p.u - before.u), v: high });
    }
    if (p.v <= high) out.push(p);
  });
  return out;
}
