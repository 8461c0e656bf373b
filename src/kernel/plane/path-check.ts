import { overlap, type Box } from "../geometry/segments.ts";
import { plane, type PlanePoint, type PlaneSegment } from "./plane.ts";
import { ARC_END, SAME } from "../tolerance.ts";

const { along, boxOf, gapBetween, lengthOf, meetings, nearestOn, apart } = plane;

/** A piece of the centre path, and the index of the contour element that it mills. */
export interface OwnedPiece {
  readonly segment: PlaneSegment;
  readonly element: number;
}

/** A place where the tool, milling one element, cuts into another that is not its neighbour on the path. */
export interface PathCut {
  /** Index of the piece of the path. */
  readonly piece: number;
  /** Index of the contour element that is cut. */
  readonly into: number;
  /** Depth of the tool beyond the contour, mm. */
  readonly depth: number;
  readonly on: PlanePoint;
}

/** Smaller depths are no cut: two arcs whose ends are off their circles come too near by this much. */
export const LEAST_PATH_CUT = 2 * ARC_END;

/** Number of elements whose boxes are checked as a group: in a long contour most of them are far away. */
const GROUP = 32;

const joined = (a: Box, b: Box): Box => ({
  left: Math.min(a.left, b.left),
  right: Math.max(a.right, b.right),
  low: Math.min(a.low, b.low),
  high: Math.max(a.high, b.high),
});
const wider = (b: Box, by: number): Box => ({
  left: b.left - by,
  right: b.right + by,
  low: b.low - by,
  high: b.high + by,
});

/** Calls with the index of every segment whose box meets a box. */
function finder(segments: readonly PlaneSegment[]): (box: Box, found: (index: number) => void) => void {
  const boxes = segments.map(boxOf),
    groups: Box[] = [];
  boxes.forEach((box, i) => {
    const group = Math.floor(i / GROUP),
      before = groups[group];
    groups[group] = before ? joined(before, box) : box;
  });
  return (box, found) => {
    groups.forEach((group, g) => {
      if (!overlap(group, box)) return;
      const end = Math.min(boxes.length, (g + 1) * GROUP);
      for (let i = g * GROUP; i < end; i += 1) {
        const each = boxes[i];
        if (each && overlap(each, box)) found(i);
      }
    });
  };
}

/**
 * A contour that crosses itself ends at the crossing: often its first and its last element are drawn beyond their
 * corner, into the air. Elements before the first and behind the last crossing are no walls.
 */
function wallsOf(contour: readonly PlaneSegment[], find: ReturnType<typeof finder>): readonly (PlaneSegment | null)[] {
  let [first, last]: [{ index: number; on: PlanePoint } | null, { index: number; on: PlanePoint } | null] = [
    null,
    null,
  ];
  contour.forEach((s, index) => {
    find(boxOf(s), (other) => {
      const t = contour[other];
      if (!t || other <= index + 1) return;
      for (const p of meetings(s, t)) {
        if (apart(nearestOn(s, p), p) > SAME || apart(nearestOn(t, p), p) > SAME) continue;
        if (!first || index < first.index || (index === first.index && along(s, p) < along(s, first.on)))
          first = { index, on: p };
        if (!last || other > last.index || (other === last.index && along(t, p) > along(t, last.on)))
          last = { index: other, on: p };
      }
    });
  });
  const [from, to] = [first, last] as [
    { index: number; on: PlanePoint } | null,
    { index: number; on: PlanePoint } | null,
  ];
  if (!from || !to) return contour;
  return contour.map((s, i) => {
    if (i < from.index || i > to.index) return null;
    const begun = i === from.index && apart(s.from, from.on) > SAME ? { ...s, from: from.on } : s;
    const ended = i === to.index && apart(s.to, to.on) > SAME ? { ...begun, to: to.on } : begun;
    return lengthOf(ended) > SAME ? ended : null;
  });
}

/**
 * The deepest place where the tool cuts into its own contour away from where it mills: a waist that is too narrow for
 * it. Neighbours on the path are checked by the compensation. `isWall` and the pieces leave out what runs above the
 * part.
 */
export function pathCut(
  contour: readonly PlaneSegment[],
  pieces: readonly OwnedPiece[],
  toolRadius: number,
  isWall: (element: number) => boolean = () => true,
): PathCut | null {
  if (!(toolRadius > 0)) return null;
  const find = finder(contour);
  let walls: readonly (PlaneSegment | null)[] | null = null;
  let worst: PathCut | null = null;
  pieces.forEach(({ segment, element }, piece) => {
    find(wider(boxOf(segment), toolRadius - LEAST_PATH_CUT), (into) => {
      const near = contour[into];
      if (!near || into === element || !isWall(into)) return;
      // At a corner of two lines the path is cut exactly at the tool radius from both.
      if (Math.abs(into - element) === 1 && near.kind === "line" && contour[element]?.kind === "line") return;
      if (toolRadius - gapBetween(segment, near).distance <= (worst?.depth ?? LEAST_PATH_CUT)) return;
      walls ??= wallsOf(contour, find);
      const wall = walls[into],
        gap = wall && gapBetween(segment, wall);
      if (gap && toolRadius - gap.distance > (worst?.depth ?? LEAST_PATH_CUT))
        worst = { piece, into, depth: toolRadius - gap.distance, on: gap.on };
    });
  });
  return worst;
}
