import type { Pt } from "../kernel/geometry/point.ts";
import { toPlace, type Camera, type Place, type Size } from "./camera.ts";
import type { Seen } from "./edge-mark.ts";
import { labelsOverlap, type LabelBox } from "./help/labels.ts";

/**
 * From a mark to the text beside it, how far a text over it reaches beyond it, and from its height to a text above or
 * below it, pixels.
 */
const BESIDE = 12,
  BEYOND = 10,
  OFF = 9;
/** Rows above and below a mark, the best first: beside it, then clear of its height, and a little further off. */
const ROWS = [0, -1, 1, -1.5, 1.5, -2, 2] as const;

/**
 * What a text should not lie on: marks on the screen, areas of which a part may rather be covered, and lines of the
 * part, mm.
 */
export interface Busy {
  readonly boxes: readonly LabelBox[];
  readonly areas: readonly LabelBox[];
  readonly lines: readonly (readonly Pt[])[];
}

/**
 * The places where a text of some size may stand by a mark at the edge of a picture, the best first: beside it, and
 * above and below it in line with it or beside it. What would lie on the `taken` corner of the picture stands left of
 * it.
 */
export function placesBeside(
  mark: Place,
  { width, height }: Size,
  room: Seen,
  taken: LabelBox | null = null,
): readonly LabelBox[] {
  const isRight = mark.x > (room.left + room.right) / 2;
  const beside = isRight ? mark.x - BESIDE - width : mark.x + BESIDE,
    over = isRight ? mark.x + BEYOND - width : mark.x - BEYOND;
  return ROWS.flatMap((row) => {
    const middle = mark.y + row * (height / 2 + OFF),
      y = Math.max(room.top, Math.min(room.bottom - height, middle - height / 2));
    // Where the edge of the picture holds it back at the height of the mark it does not stand on it.
    const isOff = y >= mark.y + OFF || y + height <= mark.y - OFF;
    return (isOff ? [over, beside] : [beside]).map((x) => {
      const box = { x, y, width, height };
      return taken && labelsOverlap(box, taken) ? { ...box, x: taken.x - width } : box;
    });
  });
}

/** Whether a line from one place to another goes through a box; all of them in the same space. */
function goesThrough(from: Pt, to: Pt, low: Pt, high: Pt): boolean {
  let [enters, leaves] = [0, 1];
  for (const axis of ["z", "r"] as const) {
    const way = to[axis] - from[axis],
      [a, b] = [low[axis] - from[axis], high[axis] - from[axis]];
    if (way === 0) {
      if (a > 0 || b < 0) return false;
      continue;
    }
    enters = Math.max(enters, Math.min(a / way, b / way));
    leaves = Math.min(leaves, Math.max(a / way, b / way));
  }
  return enters <= leaves;
}

/** How many quarters of a text lie on an area: as many as are begun. */
function quartersOn(box: LabelBox, area: LabelBox): number {
  const wide = Math.min(box.x + box.width, area.x + area.width) - Math.max(box.x, area.x);
  const tall = Math.min(box.y + box.height, area.y + area.height) - Math.max(box.y, area.y);
  return wide > 0 && tall > 0 ? Math.ceil((4 * wide * tall) / (box.width * box.height)) : 0;
}

/** How much a text would cover there: lines that run through it, areas by how much of it lies on them, and boxes. */
function covers(box: LabelBox, { boxes, areas, lines }: Busy, camera: Camera): number {
  const [a, b] = [toPlace(camera, box), toPlace(camera, { x: box.x + box.width, y: box.y + box.height })];
  const low = { z: a.z, r: a.r < b.r ? a.r : b.r },
    high = { z: b.z, r: a.r < b.r ? b.r : a.r };
  let count = 0;
  for (const line of lines) {
    for (let i = 1; i < line.length; i += 1) if (goesThrough(line[i - 1] as Pt, line[i] as Pt, low, high)) count += 1;
  }
  for (const area of areas) count += AREA * quartersOn(box, area);
  return count + BOX * boxes.filter((other) => labelsOverlap(box, other)).length;
}
/** As many lines count as much as a quarter of a text on an area, or a box. */
const AREA = 20,
  BOX = 1000;

/**
 * Which of the places covers least. The one of before stays as long as no other covers less: a text that moves on does
 * not jump about.
 */
export function leastCovering(places: readonly LabelBox[], busy: Busy, camera: Camera, before: number): number {
  const order = [before, ...places.keys()].filter((i) => i in places);
  let best = 0,
    least = Infinity;
  for (const i of order) {
    const count = covers(places[i] as LabelBox, busy, camera);
    if (count < least) [best, least] = [i, count];
    if (count === 0) break;
  }
  return best;
}
