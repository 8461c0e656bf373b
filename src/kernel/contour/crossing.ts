import { overlap, type Box } from "../geometry/segments.ts";
import { part, type Pt, type Segment } from "../geometry/point.ts";
import { ARC_END, SAME } from "../tolerance.ts";

const { along, apart, boxOf, lengthOf, meetings } = part;

/** The corner in which a segment follows another one; null where none does. */
function cornerOf(a: Segment, b: Segment): Pt | null {
  if (apart(a.to, b.from) < SAME) return a.to;
  return apart(b.to, a.from) < SAME ? b.to : null;
}

/**
 * True when two segments meet in a point that is not an end of both. A circle whose centre is rounded passes its end at
 * a little distance, and meets what follows there.
 */
function crosses(a: Segment, b: Segment): boolean {
  const [lengthA, lengthB] = [lengthOf(a), lengthOf(b)];
  const corner = cornerOf(a, b);
  return meetings(a, b).some((point) => {
    if (corner && apart(corner, point) < ARC_END) return false;
    const [onA, onB] = [along(a, point), along(b, point)];
    if (onA < -SAME || onA > lengthA + SAME || onB < -SAME || onB > lengthB + SAME) return false;
    const inA = onA > SAME && onA < lengthA - SAME;
    const inB = onB > SAME && onB < lengthB - SAME;
    return inA || inB;
  });
}

/** Two segments of a chain that cross, as indices (the later one first); null: none do. */
type Crossing = readonly [number, number] | null;

/** Cached per chain: chains are immutable and checked by several readers. */
const cachedCrossings = new WeakMap<readonly Segment[], Crossing>();

/** Two segments of a chain that cross or touch, as indices (the later one first), or null. Overlaps are not checked. */
export function selfCrossing(chain: readonly Segment[]): Crossing {
  const before = cachedCrossings.get(chain);
  if (before !== undefined) return before;
  const found = firstCrossing(chain);
  cachedCrossings.set(chain, found);
  return found;
}

/** Whether a segment crosses or touches a chain that it continues or leads to. */
export function crossesChain(one: Segment, chain: readonly Segment[]): boolean {
  const box = boxOf(one);
  return chain.some((s) => overlap(box, boxOf(s)) && crosses(one, s));
}

interface Placed {
  readonly s: Segment;
  readonly index: number;
  readonly box: Box;
}

function firstCrossing(chain: readonly Segment[]): Crossing {
  const boxes = chain.map(boxOf);
  // Fewer boxes overlap along the longer side.
  const [left, right, low, high] = boxes.reduce(
    (all, b) => [
      Math.min(all[0], b.left),
      Math.max(all[1], b.right),
      Math.min(all[2], b.low),
      Math.max(all[3], b.high),
    ],
    [Infinity, -Infinity, Infinity, -Infinity],
  );
  const [begin, end] = right - left > high - low ? (["left", "right"] as const) : (["low", "high"] as const);
  const placed = chain
    .map((s, index): Placed => ({ s, index, box: boxes[index] as Box }))
    .sort((a, b) => a.box[begin] - b.box[begin]);
  let active: Placed[] = [];
  for (const one of placed) {
    active = active.filter((other) => other.box[end] >= one.box[begin]);
    for (const other of active)
      if (overlap(one.box, other.box) && crosses(one.s, other.s))
        return [Math.max(one.index, other.index), Math.min(one.index, other.index)];
    active.push(one);
  }
  return null;
}
