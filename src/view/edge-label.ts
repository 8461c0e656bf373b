import type { Pt } from "../kernel/geometry/point.ts";
import { toPlace, type Camera, type Place, type Size } from "./camera.ts";
import type { VisibleArea } from "./edge-mark.ts";
import { arrange } from "./dimensions/arrange.ts";
import { isThrough, labelsOverlap, type LabelBox } from "./dimensions/labels.ts";

/**
 * Distance from a mark to the text beside it, overhang of a text above or below a mark, and vertical distance from a
 * mark to such a text, pixels.
 */
const BESIDE = 12,
  BEYOND = 10,
  OFF = 9;
/** Rows above and below a mark, the best first: at the mark, then clear of its height, then a little farther off. */
const ROWS = [0, -1, 1, -1.5, 1.5, -2, 2] as const;

/**
 * What a text should keep clear of: marks on the screen, areas that may be covered in part if need be, and lines of the
 * part, mm.
 */
export interface Obstacles {
  readonly boxes: readonly LabelBox[];
  readonly areas: readonly LabelBox[];
  readonly lines: readonly (readonly Pt[])[];
}

/**
 * Candidate places for a text beside a mark at the edge of a picture, the best first: beside the mark, then above and
 * below it. A text that would overlap the `taken` corner of the picture moves to the left of that corner.
 */
export function labelPlaces(
  mark: Place,
  { width, height }: Size,
  room: VisibleArea,
  taken: LabelBox | null = null,
): readonly LabelBox[] {
  const isRight = mark.x > (room.left + room.right) / 2;
  const beside = isRight ? mark.x - BESIDE - width : mark.x + BESIDE,
    over = isRight ? mark.x + BEYOND - width : mark.x - BEYOND;
  return ROWS.flatMap((row) => {
    const middle = mark.y + row * (height / 2 + OFF),
      y = Math.max(room.top, Math.min(room.bottom - height, middle - height / 2));
    // A text that the picture edge pushes back to the height of the mark must not cover the mark.
    const isOff = y >= mark.y + OFF || y + height <= mark.y - OFF;
    return (isOff ? [over, beside] : [beside]).map((x) => {
      const box = { x, y, width, height };
      return taken && labelsOverlap(box, taken) ? { ...box, x: taken.x - width } : box;
    });
  });
}

/** How many quarters of a text overlap an area, rounded up. */
function quartersOn(box: LabelBox, area: LabelBox): number {
  const wide = Math.min(box.x + box.width, area.x + area.width) - Math.max(box.x, area.x);
  const tall = Math.min(box.y + box.height, area.y + area.height) - Math.max(box.y, area.y);
  return wide > 0 && tall > 0 ? Math.ceil((4 * wide * tall) / (box.width * box.height)) : 0;
}

/** Cost of a quarter of a text on an area, in lines. */
const AREA = 20;

/** The cost of a text in a box: lines through it, and areas by the share of the text on them. */
function covers(box: LabelBox, { areas, lines }: Obstacles, camera: Camera): number {
  const [a, b] = [toPlace(camera, box), toPlace(camera, { x: box.x + box.width, y: box.y + box.height })];
  const ofPart = { x: a.z, y: Math.min(a.r, b.r), width: b.z - a.z, height: Math.abs(b.r - a.r) };
  let count = 0;
  for (const line of lines)
    line.forEach(({ z, r }, i) => {
      const before = line[i - 1];
      if (before && isThrough(before.z, before.r, z, r, ofPart)) count += 1;
    });
  for (const area of areas) count += AREA * quartersOn(box, area);
  return count;
}

/**
 * Index of the place that covers no mark and least else; least of the marks if all do. The previous place wins a tie,
 * so that a moving text does not jump about.
 */
export function leastCovering(
  places: readonly LabelBox[],
  busy: Obstacles,
  { camera, size }: { readonly camera: Camera; readonly size: Size },
  before: number,
): number {
  const candidates = [before, ...places.keys()].flatMap((row) => {
    const label = places[row];
    return label ? [{ row, label, lines: [], cost: covers(label, busy, camera) }] : [];
  });
  const [best] = arrange([{ q: "", candidates, needed: true }], { ...size, avoid: [], kept: busy.boxes });
  return best?.row ?? 0;
}
