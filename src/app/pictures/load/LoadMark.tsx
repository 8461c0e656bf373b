import type { Run } from "../../../program/state/run-types.ts";
import { textWidth } from "../../../view/dimensions/labels.ts";
import { useProjection, type PlaceProjection } from "../lathe/place-projection.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useGreatest, loadValue, type LoadQuantity } from "./use-load.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

export interface LoadMarkProps {
  readonly of: LoadQuantity;
  readonly run: Run;
  readonly seeing: PlaceProjection;
}

/** Mark of the highest value, pixels: its half size, and the distance of its number. */
const HALF = 9;
const ASIDE = 14;
/** Size of the number, and padding of its background, pixels. */
const [TEXT, GROUND] = [12, 3];

/** The place of the highest value, with its number. */
export function LoadMark({ of, run, seeing }: LoadMarkProps) {
  const t = useTexts("load"),
    lengths = useLengths();
  const seen = useProjection(seeing),
    { width } = seen.size();
  const { worst } = useGreatest(run, of) ?? {};
  const at = worst && seen.at(worst.place);
  if (!worst || !at) return null;
  const { x, y } = at,
    isRight = x > width / 2,
    begin = isRight ? x - ASIDE : x + ASIDE;
  const said = loadValue(t, lengths, of, worst.value),
    wide = textWidth(said, TEXT) + 2 * GROUND;
  return (
    <g className="load-mark" aria-hidden="true">
      <path d={`M${x - HALF} ${y}L${x} ${y - HALF}L${x + HALF} ${y}L${x} ${y + HALF}Z`} />
      <rect
        x={isRight ? begin + GROUND - wide : begin - GROUND}
        y={y - HALF - TEXT}
        width={wide}
        height={TEXT + 2 * GROUND}
        rx="3"
      />
      <text x={begin} y={y - HALF} textAnchor={isRight ? "end" : "start"}>
        {said}
      </text>
    </g>
  );
}
