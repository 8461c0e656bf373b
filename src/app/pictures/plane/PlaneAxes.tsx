import { memo } from "react";
import { formatNumber } from "../../../i18n/number.ts";
import { partPoint, planePoint } from "../../../kernel/plane/plane.ts";
import { toPlace, toScreen } from "../../../view/camera.ts";
import { ticks } from "../../../view/ticks.ts";
import { SCALE_BELOW, SCALE_LEFT } from "../lathe/Axes.tsx";
import { useCamera } from "../lathe/use-camera.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { useLengths } from "../../calculation/lengths.ts";

/** Smallest distance of two marks. */
const APART = { x: 72, y: 44 };

/** Grid and scales of the working plane: X along the lower edge, Y along the left one, both axes as chain lines. */
export const PlaneAxes = memo(function PlaneAxes({
  viewport,
  part,
}: {
  readonly viewport: Viewport;
  readonly part: "grid" | "scales";
}) {
  const camera = useCamera(viewport),
    { width, height } = viewport.size();
  const { language, per, unit } = useLengths();
  const corner = planePoint(toPlace(camera, { x: 0, y: 0 })),
    far = planePoint(toPlace(camera, { x: width, y: height }));
  const alongX = ticks(corner.x / per, far.x / per, APART.x / camera.scale / per),
    alongY = ticks(corner.y / per, far.y / per, APART.y / camera.scale / per);
  const placeX = (x: number) => toScreen(camera, partPoint({ x: x * per, y: 0 })).x;
  const placeY = (y: number) => toScreen(camera, partPoint({ x: 0, y: y * per })).y;
  const right = SCALE_LEFT,
    floor = height - SCALE_BELOW;
  if (part === "grid") {
    const lines =
      alongX.values.map((x) => `M${placeX(x)} 0V${height}`).join("") +
      alongY.values.map((y) => `M0 ${placeY(y)}H${width}`).join("");
    return (
      <g>
        <path className="lathe-grid" d={lines} />
        <path className="lathe-axis" d={`M0 ${placeY(0)}H${width}M${placeX(0)} 0V${height}`} />
      </g>
    );
  }
  const shownX = alongX.values.map((v) => ({ v, x: placeX(v) })).filter(({ x }) => x > right + 16 && x < width - 28);
  const shownY = alongY.values.map((v) => ({ v, y: placeY(v) })).filter(({ y }) => y > 28 && y < floor - 6);
  return (
    <g className="lathe-scales" aria-hidden="true">
      <path className="lathe-scale-ground" d={`M0 0H${right}V${floor}H${width}V${height}H0Z`} />
      <path className="lathe-scale-edge" d={`M${right} 0V${floor}H${width}`} />
      <path
        className="lathe-tick"
        d={shownX.map(({ x }) => `M${x} ${floor}v4`).join("") + shownY.map(({ y }) => `M${right} ${y}h-4`).join("")}
      />
      {shownX.map(({ v, x }, i) => (
        <text key={i} x={x} y={height - 6} textAnchor="middle">
          {formatNumber(language, v, alongX.decimals)}
        </text>
      ))}
      {shownY.map(({ v, y }, i) => (
        <text key={i} x={right - 7} y={y + 4} textAnchor="end">
          {formatNumber(language, v, alongY.decimals)}
        </text>
      ))}
      <text className="lathe-scale-name" x={right - 7} y={16} textAnchor="end">
        Y
      </text>
      <text className="lathe-scale-name" x={width - 8} y={height - 6} textAnchor="end">
        {unit === "mm" ? "X" : `X ${unit}`}
      </text>
    </g>
  );
});
