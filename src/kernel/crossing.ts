import { along, at, lengthOf, meet, track } from "./curve.ts";
import type { Segment } from "./point.ts";
import { SAME } from "./tolerance.ts";

interface Box {
  readonly index: number;
  readonly zMin: number;
  readonly zMax: number;
  readonly rMin: number;
  readonly rMax: number;
}

/** A box round a segment; round an arc it holds the full circle. */
function boxOf(s: Segment, index: number): Box {
  if (s.kind === "arc") {
    const size = Math.hypot(s.from.z - s.centre.z, s.from.r - s.centre.r);
    return { index, zMin: s.centre.z - size, zMax: s.centre.z + size, rMin: s.centre.r - size, rMax: s.centre.r + size };
  }
  return {
    index, zMin: Math.min(s.from.z, s.to.z), zMax: Math.max(s.from.z, s.to.z), rMin: Math.min(s.from.r, s.to.r), rMax: Math.max(s.from.r, s.to.r),
  };
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
