import { part, type Pt, type Segment, type Turn } from "../geometry/point.ts";
import { ROUND, SAME } from "../tolerance.ts";

const { along, beyond, cross, curveBeside, direction, footOn, lengthOf, meet } = part;

/** An element on a corner of a contour: a chamfer with equal legs along both lines, or a tangential arc. Size in mm. */
export interface CornerElement {
  readonly kind: "chamfer" | "round";
  readonly size: number;
}

/** Both neighbours shortened, and the element between them. */
export interface Cut {
  readonly before: Segment;
  readonly between: Segment;
  readonly after: Segment;
}

/**
 * A segment shortened to nothing becomes a line without length: an arc from a point to itself would be a full circle.
 */
const ending = (s: Segment, to: Pt): Segment =>
  along(s, to) > SAME ? { ...s, to } : { kind: "line", from: s.from, to };
const starting = (s: Segment, from: Pt): Segment =>
  lengthOf(s) - along(s, from) > SAME ? { ...s, from } : { kind: "line", from, to: s.to };

function rounded(before: Segment, after: Segment, r: number): Cut | null {
  const bend = cross(direction(before, before.to), direction(after, after.from));
  const turn: Turn = bend > 0 ? "ccw" : "cw";
  const [one, two] = [curveBeside(before, r, turn), curveBeside(after, r, turn)];
  if (!one || !two) return null;
  let best: Cut | null = null;
  let loss = Infinity;
  for (const c of meet(one, two)) {
    const [from, to] = [footOn(before, c), footOn(after, c)];
    const [keep, skip] = [along(before, from), along(after, to)];
    const lost = lengthOf(before) - keep + skip;
    if (
      keep < -ROUND ||
      skip < -ROUND ||
      keep > lengthOf(before) + ROUND ||
      skip > lengthOf(after) + ROUND ||
      lost >= loss
    )
      continue;
    loss = lost;
    const between: Segment = { kind: "arc", from, to, centre: c, turn };
    best = { before: ending(before, from), between, after: starting(after, to) };
  }
  return best;
}

/** Puts an element on the corner between two segments that meet; null when it does not fit. */
export function cutCorner(before: Segment, after: Segment, corner: CornerElement): Cut | null {
  if (corner.kind === "round") return rounded(before, after, corner.size);
  if (before.kind === "arc" || after.kind === "arc") return null;
  const [one, two] = [lengthOf(before), lengthOf(after)];
  if (corner.size > one + ROUND || corner.size > two + ROUND) return null;
  const [back, on] = [direction(before, before.to), direction(after, after.from)];
  const from = beyond(before.to, back, -corner.size);
  const to = beyond(after.from, on, corner.size);
  return { before: { ...before, to: from }, between: { kind: "line", from, to }, after: { ...after, from: to } };
}
