import type { Run } from "../../program/run-types.ts";
import { useSeeing, type Seeing } from "../lathe/seeing.ts";
import { useLengths } from "../lengths.ts";
import { useGreatest, useLoadTexts, loadValue, type Told } from "./use-load.ts";

export interface LoadMarkProps {
  readonly of: Told;
  readonly run: Run;
  readonly seeing: Seeing;
}

/** The mark of the worst place, pixels: its half size, and how far beside it the number stands. */
const HALF = 9;
const ASIDE = 14;

/** The worst place, marked and with its value. */
export function LoadMark({ of, run, seeing }: LoadMarkProps) {
  const t = useLoadTexts(), lengths = useLengths();
  const seen = useSeeing(seeing), { width } = seen.size();
  const { worst } = useGreatest(run, of) ?? {};
  const at = worst && seen.at(worst.place);
  if (!worst || !at) return null;
  const { x, y } = at, isRight = x > width / 2;
  return (
    <g className="load-mark" aria-hidden="true">
      <path d={`M${x - HALF} ${y}L${x} ${y - HALF}L${x + HALF} ${y}L${x} ${y + HALF}Z`} />
      <text x={isRight ? x - ASIDE : x + ASIDE} y={y - HALF} textAnchor={isRight ? "end" : "start"}>
        {loadValue(t, lengths, of, worst.value)}
      </text>
    </g>
  );
}
