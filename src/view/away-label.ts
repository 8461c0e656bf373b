import type { Pt } from "../kernel/point.ts";
import { toPlace, type Camera, type Place, type Size } from "./camera.ts";
import type { Seen } from "./edge-mark.ts";
import { labelsOverlap, type LabelBox } from "./help/labels.ts";

/** From a mark to the text beside it, and from the height of the mark to a text above or below it, pixels. */
const BESIDE = 12, OFF = 9;
/** Rows above and below a mark, the best first: beside it, then clear of its height, and further off. */
const ROWS = [0, -1, 1, -2, 2, -3, 3] as const;

/** What a text should not lie on: boxes on the screen, and lines of the part, mm. */
export interface Busy {
  readonly boxes: readonly LabelBox[];
  readonly lines: readonly (readonly Pt[])[];
}

/** The places where a text of some size may stand beside a mark at the edge of a picture, the best first. */
export function placesBeside(mark: Place, { width, height }: Size, room: Seen): readonly LabelBox[] {
  const x = mark.x > (room.left + room.right) / 2 ? mark.x - BESIDE - width : mark.x + BESIDE;
  return ROWS.map((row) => {
    const middle = mark.y + row * (height / 2 + OFF);
    return { x, y: Math.max(room.top, Math.min(room.bottom - height, middle - height / 2)), width, height };
  });
}

/** Whether a line from one place to another goes through a box; all of them in the same space. */
function goesThrough(from: Pt, to: Pt, low: Pt, high: Pt): boolean {
  let [enters, leaves] = [0, 1];
  for (const axis of ["z", "r"] as const) {
    const way = to[axis] - from[axis], [a, b] = [low[axis] - from[axis], high[axis] - from[axis]];
    if (way === 0) {
      if (a > 0 || b < 0) return false;
      continue;
    }
    enters = Math.max(enters, Math.min(a / way, b / way));
    leaves = Math.min(leaves, Math.max(a / way, b / way));
  }
  return enters <= leaves;
}

/** How much a text would cover there: lines that run through it, and boxes, each of which counts as many. */
function covers(box: LabelBox, { boxes, lines }: Busy, camera: Camera): number {
  const [a, b] = [toPlace(camera, box), toPlace(camera, { x: box.x + box.width, y: box.y + box.height })];
  const low = { z: a.z, r: a.r < b.r ? a.r : b.r }, high = { z: b.z, r: a.r < b.r ? b.r : a.r };
  let count = 0;
  for (const line of lines) {
    for (let i = 1; i < line.length; i += 1) if (goesThrough(line[i - 1] as Pt, line[i] as Pt, low, high)) count += 1;
  }
  return count + BOX * boxes.filter((other) => labelsOverlap(box, other)).length;
}
const BOX = 1000;

/** Which of the places covers least. The one of before stays as long as no other covers less: a text that moves on does not jump about. */
export function leastCovering(places: readonly LabelBox[], busy: Busy, camera: Camera, before: number): number {
  const order = [before, ...places.keys()].filter((i) => i in places);
  let best = 0, least = Infinity;
  for (const i of order) {
    const count = covers(places[i] as LabelBox, busy, camera);
    if (count < least) [best, least] = [i, count];
    if (count === 0) break;
  }
  return best;
}
