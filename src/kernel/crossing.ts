import { overlap, type Box } from "./geometry/segments.ts";
import { part, type Segment } from "./point.ts";
import { SAME } from "./tolerance.ts";

const { along, boxOf, lengthOf, meetings } = part;

/** True when two segments meet in a point that is not an end of both. */
function crosses(a: Segment, b: Segment): boolean {
  const [lengthA, lengthB] = [lengthOf(a), lengthOf(b)];
  return meetings(a, b).some((point) => {
    const [onA, onB] = [along(a, point), along(b, point)];
    if (onA < -SAME || onA > lengthA + SAME || onB < -SAME || onB > lengthB + SAME) return false;
    const inA = onA > SAME && onA < lengthA - SAME;
    const inB = onB > SAME && onB < lengthB - SAME;
    return inA || inB;
  });
}

/** Two segments of a chain that cross or touch, as indices (the later one first), or null. Overlaps are not looked for. */
export function selfCrossing(chain: readonly Segment[]): readonly [number, number] | null {
  const placed = chain.map((s, index) => ({ s, index, box: boxOf(s) })).sort((a, b) => a.box.left - b.box.left);
  let active: { s: Segment; index: number; box: Box }[] = [];
  for (const one of placed) {
    active = active.filter((other) => other.box.right >= one.box.left);
    for (const other of active)
      if (overlap(one.box, other.box) && crosses(one.s, other.s))
        return [Math.max(one.index, other.index), Math.min(one.index, other.index)];
    active.push(one);
  }
  return null;
}
