import { memo } from "react";
import { diameter, toDiameter, toRadius, axial, radius } from "../../../kernel/units.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { toPlace, toScreen, type Camera, type Size } from "../../../view/camera.ts";
import { ticks } from "../../../view/ticks.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useCamera } from "./use-camera.ts";
import type { Viewport } from "./viewport.ts";

/** Widths of the scales at the left and the lower edge. */
export const SCALE_LEFT = 46;
export const SCALE_BELOW = 22;
/** Smallest distance of two marks. */
const APART = { z: 72, x: 44 };

/** Grid and scales: Z along the lower edge, X as diameter along the left one, the spindle axis as a chain line. */
export const LatheAxes = memo(function LatheAxes({
  viewport,
  part,
}: {
  readonly viewport: Viewport;
  readonly part: "grid" | "scales";
}) {
  return <CameraAxes camera={useCamera(viewport)} size={viewport.size()} part={part} />;
});

/** Grid and scales of a picture that handles its camera itself. */
export function CameraAxes({
  camera,
  size: { width, height },
  part,
}: {
  readonly camera: Camera;
  readonly size: Size;
  readonly part: "grid" | "scales";
}) {
  const { language, per, unit: counted } = useLengths(),
    t = useTexts().lathe;
  const corner = toPlace(camera, { x: 0, y: 0 }),
    far = toPlace(camera, { x: width, y: height });
  const alongZ = ticks(corner.z / per, far.z / per, APART.z / camera.scale / per);
  const alongX = ticks(
    toDiameter(corner.r) / per,
    toDiameter(far.r) / per,
    toDiameter(radius(APART.x / camera.scale)) / per,
  );
  const placeZ = (z: number) => toScreen(camera, { z: axial(z * per), r: radius(0) }).x;
  const placeX = (x: number) => toScreen(camera, { z: axial(0), r: toRadius(diameter(x * per)) }).y;
  const right = SCALE_LEFT,
    floor = height - SCALE_BELOW;
  if (part === "grid") {
    const lines =
      alongZ.values.map((z) => `M${placeZ(z)} 0V${height}`).join("") +
      alongX.values.map((x) => `M0 ${placeX(x)}H${width}`).join("");
    return (
      <g>
        <path className="lathe-grid" d={lines} />
        <path className="lathe-axis" d={`M0 ${placeX(0)}H${width}`} />
      </g>
    );
  }
  const shownZ = alongZ.values.map((z) => ({ z, x: placeZ(z) })).filter(({ x }) => x > right + 16 && x < width - 28);
  const shownX = alongX.values.map((x) => ({ x, y: placeX(x) })).filter(({ y }) => y > 28 && y < floor - 6);
  return (
    <g className="lathe-scales" aria-hidden="true">
      <path className="lathe-scale-ground" d={`M0 0H${right}V${floor}H${width}V${height}H0Z`} />
      <path className="lathe-scale-edge" d={`M${right} 0V${floor}H${width}`} />
      <path
        className="lathe-tick"
        d={shownZ.map(({ x }) => `M${x} ${floor}v4`).join("") + shownX.map(({ y }) => `M${right} ${y}h-4`).join("")}
      />
      {shownZ.map(({ z, x }, i) => (
        <text key={i} x={x} y={height - 6} textAnchor="middle">
          {formatNumber(language, z, alongZ.decimals)}
        </text>
      ))}
      {shownX.map(({ x, y }, i) => (
        <text key={i} x={right - 7} y={y + 4} textAnchor="end">
          {formatNumber(language, x, alongX.decimals)}
        </text>
      ))}
      <text className="lathe-scale-name" x={right - 7} y={16} textAnchor="end">
        {t.axisX}
      </text>
      <text className="lathe-scale-name" x={width - 8} y={height - 6} textAnchor="end">
        {counted === "mm" ? t.axisZ : `${t.axisZ} ${counted}`}
      </text>
    </g>
  );
}
