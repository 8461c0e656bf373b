import { memo } from "react";
import { formatNumber } from "../../../i18n/number.ts";
import type { Radius } from "../../../kernel/units.ts";
import { axial, diameter, radius, toDiameter, toRadius } from "../../../kernel/units.ts";
import { toPlace, toScreen, type Camera, type Size } from "../../../view/camera.ts";
import { ticks } from "../../../view/ticks.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useLengths } from "../../calculation/lengths.ts";
import type { MeasureSource } from "../measure/source.ts";
import { useCamera } from "./use-camera.ts";
import type { Viewport } from "./viewport.ts";

/** Widths of the scales at the left and the lower edge. */
export const SCALE_LEFT = 46;
export const SCALE_BELOW = 22;
/** Smallest distance of two marks. */
const APART = { across: 72, up: 44 };

/** What the left scale counts: diameters of the half plane, Y of the working plane. */
const UP: Readonly<Record<Plane, { readonly of: (r: Radius) => number; readonly at: (value: number) => Radius }>> = {
  ZX: { of: toDiameter, at: (value) => toRadius(diameter(value)) },
  XY: { of: (r) => r, at: radius },
};
type Plane = MeasureSource["plane"];
type Part = "grid" | "scales";

/** Grid and scales of a plane: its axes as chain lines, Z or X along the lower edge, X as diameter or Y along the left. */
export const Axes = memo(function Axes({
  viewport,
  part,
  plane = "ZX",
}: {
  readonly viewport: Viewport;
  readonly part: Part;
  readonly plane?: Plane;
}) {
  return <CameraAxes camera={useCamera(viewport)} size={viewport.size()} part={part} plane={plane} />;
});

/** Grid and scales of a picture that handles its camera itself. */
export function CameraAxes({
  camera,
  size: { width, height },
  part,
  plane = "ZX",
}: {
  readonly camera: Camera;
  readonly size: Size;
  readonly part: Part;
  readonly plane?: Plane;
}) {
  const { language, per, unit: counted } = useLengths(),
    t = useTexts().lathe;
  const counts = UP[plane],
    names = plane === "ZX" ? { across: t.axisZ, up: t.axisX } : { across: "X", up: "Y" };
  const corner = toPlace(camera, { x: 0, y: 0 }),
    far = toPlace(camera, { x: width, y: height });
  const across = ticks(corner.z / per, far.z / per, APART.across / camera.scale / per),
    up = ticks(counts.of(corner.r) / per, counts.of(far.r) / per, counts.of(radius(APART.up / camera.scale)) / per);
  const placeAcross = (value: number) => toScreen(camera, { z: axial(value * per), r: radius(0) }).x;
  const placeUp = (value: number) => toScreen(camera, { z: axial(0), r: counts.at(value * per) }).y;
  const right = SCALE_LEFT,
    floor = height - SCALE_BELOW;
  if (part === "grid") {
    const lines =
      across.values.map((value) => `M${placeAcross(value)} 0V${height}`).join("") +
      up.values.map((value) => `M0 ${placeUp(value)}H${width}`).join("");
    return (
      <g>
        <path className="lathe-grid" d={lines} />
        <path
          className="lathe-axis"
          d={`M0 ${placeUp(0)}H${width}${plane === "XY" ? `M${placeAcross(0)} 0V${height}` : ""}`}
        />
      </g>
    );
  }
  const below = across.values
    .map((value) => ({ value, x: placeAcross(value) }))
    .filter(({ x }) => x > right + 16 && x < width - 28);
  const left = up.values.map((value) => ({ value, y: placeUp(value) })).filter(({ y }) => y > 28 && y < floor - 6);
  return (
    <g className="lathe-scales" aria-hidden="true">
      <path className="lathe-scale-ground" d={`M0 0H${right}V${floor}H${width}V${height}H0Z`} />
      <path className="lathe-scale-edge" d={`M${right} 0V${floor}H${width}`} />
      <path
        className="lathe-tick"
        d={below.map(({ x }) => `M${x} ${floor}v4`).join("") + left.map(({ y }) => `M${right} ${y}h-4`).join("")}
      />
      {below.map(({ value, x }, i) => (
        <text key={i} x={x} y={height - 6} textAnchor="middle">
          {formatNumber(language, value, across.decimals)}
        </text>
      ))}
      {left.map(({ value, y }, i) => (
        <text key={i} x={right - 7} y={y + 4} textAnchor="end">
          {formatNumber(language, value, up.decimals)}
        </text>
      ))}
      <text className="lathe-scale-name" x={right - 7} y={16} textAnchor="end">
        {names.up}
      </text>
      <text className="lathe-scale-name" x={width - 8} y={height - 6} textAnchor="end">
        {counted === "mm" ? names.across : `${names.across} ${counted}`}
      </text>
    </g>
  );
}
