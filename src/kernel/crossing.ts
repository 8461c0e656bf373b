import { along, at, lengthOf, meet, track } from "./curve.ts";
import { pointRound, polarOf } from "./flatten.ts";
import type { Pt, Segment } from "./point.ts";
import { SAME } from "./tolerance.ts";

interface Box {
  readonly index: number;
  readonly zMin: number;
  readonly zMax: number;
  readonly rMin: number;
  readonly rMax: number;
}

/** A box round a segment: round its ends, and round the places where an arc runs along an axis. */
function boxOf(s: Segment, index: number): Box {
  const points: Pt[] = [s.from, s.to];
  if (s.kind === "arc") {
    const polar = polarOf(s);
    const [low, high] = [Math.min(polar.start, polar.start + polar.sweep), Math.max(polar.start, polar.start + polar.sweep)];
    for (let k = Math.ceil(low / (Math.PI / 2)); k * (Math.PI / 2) <= high; k += 1)
      points.push(pointRound(s.centre, polar, (k * (Math.PI / 2) - polar.start) / polar.sweep));
  }
  const [z, r] = [points.map((p) => p.z), points.map((p) => p.r)];
  return { index, zMin: Math.min(...z), zMax: Math.max(...z), rMin: Math.min(...r), rMax: Math.max(...r) };
}

/** True when two segments meet in a point that is not an end of both. */
function crosses(a: Segment, b: Segment): boolean {
  const [one, two] = [track(a, 0, "ccw"), track(b, 0, "ccw")];
  if (!one || !two) return false;
  const [lengthA, lengthB] = [lengthOf(a), lengthOf(b)];
  return meet(one, two).some((v) => {
    const point = at(v.z, v.r);
    const [onA, onB] = [along(a, point), along(b, point)];
    if (onA < -SAME || onA > lengthA + SAME || onB < -SAME || onB > lengthB + SAME) return false;
    const inA = onA > SAME && onA < lengthA - SAME;
    const inB = onB > SAME && onB < lengthB - SAME;
    return inA || inB;
  });
}

/** Two segments of a chain that cross or touch, as indices (the later one first), or null. Overlaps are not looked for. */
export function selfCrossing(chain: readonly Segment[]): readonly [number, number] | null {
  const boxes = chain.map(boxOf).sort((a, b) => a.zMin - b.zMin);
  let active: Box[] = [];
  for (const box of boxes) {
    active = active.filter((other) => other.zMax >= box.zMin);
    for (const other of active) {
      const [a, b] = [chain[box.index], chain[other.index]];
      if (other.rMin > box.rMax || other.rMax < box.rMin || !a || !b) continue;
      if (crosses(a, b)) return box.index > other.index ? [box.index, other.index] : [other.index, box.index];
    }
    active.push(box);
  }
  return null;
}
