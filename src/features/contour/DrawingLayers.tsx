import type { Ring } from "../../kernel/geometry/point.ts";
import { part } from "../../kernel/geometry/point.ts";
import { axial, diameter, toRadius } from "../../kernel/units.ts";
import { holdsOf, type Hold } from "../../program/job/contour-dimensions.ts";
import type { RowsReading } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { toScreen, type Camera, type Place, type Size } from "../../view/camera.ts";
import type { ContourPicture } from "../../view/help/contour-drawing.ts";
import { polygon, polyline, px } from "../../view/help/marks.ts";
import type { Pointing } from "./use-drawing.ts";

/** The outline of the blank, under the contour. */
export function BlankOutline({ blank, camera }: { readonly blank: readonly Ring[]; readonly camera: Camera }) {
  return <path className="blank" d={blank.map((ring) => polygon(ring.map((p) => toScreen(camera, p)))).join("")} />;
}

const HOLD_SIGNS: Readonly<Record<Hold, string>> = { tangent: "T", horizontal: "", vertical: "", sought: "?" };
const STROKES: Partial<Record<Hold, string>> = { horizontal: "M-5 0H5", vertical: "M0 -5V5" };
/** Elements shorter than this on the screen have no room for their signs, pixels. */
const ROOM = 46;
const BESIDE = 15,
  STEP = 17;

/** Small signs next to the middle of each element: its constraints besides typed coordinates. */
export function HoldSigns({
  rows,
  reading,
  picture,
  active,
}: {
  readonly rows: readonly ContourRow[];
  readonly reading: RowsReading;
  readonly picture: ContourPicture;
  readonly active: number | null;
}) {
  const firstOf = new Map<number, number>();
  for (const [segment, row] of reading.rowOfSegment.entries()) if (!firstOf.has(row)) firstOf.set(row, segment);
  return (
    <g className="holds" aria-hidden="true">
      {rows.map((row, i) => {
        const read = reading.rows[i],
          own = reading.contour.segments[firstOf.get(i) ?? -1];
        const holds = read ? holdsOf(row, read) : [];
        if (!own || holds.length === 0) return null;
        const [a, b] = [toScreen(picture.camera, own.from), toScreen(picture.camera, own.to)],
          long = Math.hypot(b.x - a.x, b.y - a.y);
        if (long < ROOM && i !== active) return null;
        const middle = toScreen(picture.camera, part.pointOn(own, 0.5)),
          along = { x: (b.x - a.x) / (long || 1), y: (b.y - a.y) / (long || 1) };
        // On the material side of the element; dimensions are on the other side.
        const down = along.x > 0 ? { x: -along.y, y: along.x } : { x: along.y, y: -along.x };
        return holds.map((hold, k) => {
          const far = (k - (holds.length - 1) / 2) * STEP;
          return (
            <g
              key={`${row.id} ${hold}`}
              className={`hold ${hold}${i === active ? " active" : ""}`}
              transform={`translate(${px(middle.x + down.x * BESIDE + along.x * far)} ${px(middle.y + down.y * BESIDE + along.y * far)})`}
            >
              <rect x="-7" y="-7" width="14" height="14" rx="3" />
              {STROKES[hold] ? <path d={STROKES[hold]} /> : <text>{HOLD_SIGNS[hold]}</text>}
            </g>
          );
        });
      })}
    </g>
  );
}

/**
 * The snap lines of the pointer: through other points, along the tangent of the previous element, and the snapped
 * place.
 */
export function SnapLines({
  pointing,
  from,
  camera,
  size,
}: {
  readonly pointing: Pointing;
  /** Start of the new element; null while none is drawn. */
  readonly from: Place | null;
  readonly camera: Camera;
  readonly size: Size;
}) {
  const { spot, onX, onZ, ray } = pointing.aim;
  const at = toScreen(camera, part.point(axial(spot.z), toRadius(diameter(spot.x))));
  return (
    <g className="snapping" aria-hidden="true">
      {onX && <path className="guide" d={`M0 ${px(at.y)}H${px(size.width)}`} />}
      {onZ && <path className="guide" d={`M${px(at.x)} 0V${px(size.height)}`} />}
      {ray && <path className="guide" d={polyline([toScreen(camera, ray.from), at])} />}
      {ray && (
        <text x={px(at.x + 14)} y={px(at.y - 12)}>
          T
        </text>
      )}
      {from && <path className="rubber" d={polyline([from, at])} />}
      <path className="aim" d={`M${px(at.x - 9)} ${px(at.y)}h18M${px(at.x)} ${px(at.y - 9)}v18`} />
    </g>
  );
}
