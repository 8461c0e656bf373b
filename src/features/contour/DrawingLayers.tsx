import type { Ring } from "../../kernel/geometry/point.ts";
import { part } from "../../kernel/geometry/point.ts";
import { axial, diameter, toRadius } from "../../kernel/units.ts";
import type { Hold } from "../../program/job/contour-dimensions.ts";
import { toScreen, type Camera, type Place, type Size } from "../../view/camera.ts";
import { polygon, polyline, px } from "../../view/help/marks.ts";
import type { HoldSign } from "./hold-signs.ts";
import type { Pointing } from "./use-drawing.ts";

/** The outline of the blank, under the contour. */
export function BlankOutline({ blank, camera }: { readonly blank: readonly Ring[]; readonly camera: Camera }) {
  return <path className="blank" d={blank.map((ring) => polygon(ring.map((p) => toScreen(camera, p)))).join("")} />;
}

const HOLD_SIGNS: Readonly<Record<Hold, string>> = { tangent: "T", horizontal: "", vertical: "", sought: "?" };
const STROKES: Partial<Record<Hold, string>> = { horizontal: "M-5 0H5", vertical: "M0 -5V5" };

/** Small signs next to the middle of each element: its constraints besides typed coordinates. */
export function HoldSigns({ signs, active }: { readonly signs: readonly HoldSign[]; readonly active: number | null }) {
  return (
    <g className="holds" aria-hidden="true">
      {signs.map(({ key, hold, row, at }) => (
        <g
          key={key}
          className={`hold ${hold}${row === active ? " active" : ""}`}
          transform={`translate(${px(at.x)} ${px(at.y)})`}
        >
          <rect x="-7" y="-7" width="14" height="14" rx="3" />
          {STROKES[hold] ? <path d={STROKES[hold]} /> : <text>{HOLD_SIGNS[hold]}</text>}
        </g>
      ))}
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
