import { part } from "../../kernel/geometry/point.ts";
import { holdsOf, type Hold } from "../../program/job/contour-dimensions.ts";
import type { RowsReading } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { toScreen, type Place } from "../../view/camera.ts";
import type { ContourPicture } from "../../view/help/contour-drawing.ts";
import { labelsOverlap, type LabelBox } from "../../view/dimensions/labels.ts";

/** A sign of a constraint on the drawing, with its middle. */
export interface HoldSign {
  readonly key: string;
  readonly hold: Hold;
  readonly row: number;
  readonly at: Place;
  readonly box: LabelBox;
}

/** Elements shorter than this on the screen have no room for their signs, pixels. */
const ROOM = 46;
/** Distance of a sign from its element, from sign to sign, and half its size, pixels. */
const BESIDE = 15,
  STEP = 17,
  HALF = 7.5;
/** Shifts along the element, in signs, the nearest first. */
const SHIFTS = [0, 1, -1, 2, -2] as const;

/**
 * Signs next to the middle of each element, clear of points, numbers and each other: on the material side of the
 * element, since dimensions are on the other side.
 */
export function holdSigns(
  rows: readonly ContourRow[],
  reading: RowsReading,
  { camera, kept }: Pick<ContourPicture, "camera" | "kept">,
  active: number | null,
): readonly HoldSign[] {
  const firstOf = new Map<number, number>(),
    signs: HoldSign[] = [];
  for (const [segment, row] of reading.rowOfSegment.entries()) if (!firstOf.has(row)) firstOf.set(row, segment);
  const isFree = (box: LabelBox) =>
    !kept.some((other) => labelsOverlap(box, other)) && !signs.some((other) => labelsOverlap(box, other.box));
  rows.forEach((row, i) => {
    const read = reading.rows[i],
      own = reading.contour.segments[firstOf.get(i) ?? -1];
    if (!read || !own) return;
    const [a, b] = [toScreen(camera, own.from), toScreen(camera, own.to)],
      long = Math.hypot(b.x - a.x, b.y - a.y);
    if (long < ROOM && i !== active) return;
    const middle = toScreen(camera, part.pointOn(own, 0.5)),
      along = { x: (b.x - a.x) / (long || 1), y: (b.y - a.y) / (long || 1) };
    const down = along.x > 0 ? { x: -along.y, y: along.x } : { x: along.y, y: -along.x };
    for (const hold of holdsOf(row, read)) {
      const places = [1, -1].flatMap((side) =>
        SHIFTS.map((shift): Place => ({
          x: middle.x + side * down.x * BESIDE + along.x * shift * STEP,
          y: middle.y + side * down.y * BESIDE + along.y * shift * STEP,
        })),
      );
      const boxed = places.map((at) => ({
        at,
        box: { x: at.x - HALF, y: at.y - HALF, width: 2 * HALF, height: 2 * HALF },
      }));
      const put = boxed.find(({ box }) => isFree(box));
      if (put) signs.push({ key: `${row.id} ${hold}`, hold, row: i, ...put });
    }
  });
  return signs;
}
