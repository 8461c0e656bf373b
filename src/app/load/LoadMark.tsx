import type { Run } from "../../program/run-types.ts";
import { toScreen } from "../../view/camera.ts";
import { useCamera } from "../lathe/use-camera.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { useSettings } from "../settings/settings.ts";
import { useGreatest, useLoadTexts, loadValue, type Told } from "./use-load.ts";

export interface LoadMarkProps {
  readonly of: Told;
  readonly run: Run;
  readonly viewport: Viewport;
}

/** The mark of the worst place, pixels: its half size, and how far beside it the number stands. */
const HALF = 9;
const ASIDE = 14;

/** The worst place, marked and with its value. */
export function LoadMark({ of, run, viewport }: LoadMarkProps) {
  const t = useLoadTexts(), language = useSettings((s) => s.language);
  const camera = useCamera(viewport), { width } = viewport.size();
  const { worst } = useGreatest(run, of) ?? {};
  if (!worst) return null;
  const { x, y } = toScreen(camera, worst.place), isRight = x > width / 2;
  return (
    <g className="load-mark" aria-hidden="true">
      <path d={`M${x - HALF} ${y}L${x} ${y - HALF}L${x + HALF} ${y}L${x} ${y + HALF}Z`} />
      <text x={isRight ? x - ASIDE : x + ASIDE} y={y - HALF} textAnchor={isRight ? "end" : "start"}>
        {loadValue(t, language, of, worst.value)}
      </text>
    </g>
  );
}
