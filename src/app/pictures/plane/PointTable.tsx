import type { PlanePoint } from "../../../kernel/plane/plane.ts";
import type { ApproachRun } from "../../../program/tools/plane-types.ts";
import type { ApproachWords } from "../../../view/approach/words.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

/** All named points of approaches and departures in words; PA and PE on the contour, then the tool centre there. */
export function PointTable({
  approaches,
  speech,
}: {
  readonly approaches: readonly ApproachRun[];
  readonly speech: ApproachWords;
}) {
  const t = useTexts().approach;
  const where = ({ departing, request: { element } }: ApproachRun, name: string, at: PlanePoint) =>
    name === (departing ? "PE" : "PA")
      ? `${speech.contour(departing ? element.to : element.from)} · ${t.dots.centre} ${speech.point(at)}`
      : speech.point(at);
  if (approaches.length === 0) return null;
  return (
    <details>
      <summary>{t.pointTable}</summary>
      <ul className="plane-point-list number small">
        {approaches.flatMap((a, i) =>
          Object.entries(a.points).map(([name, at]) => (
            <li key={`${i} ${name}`}>{t.pointAt(name, where(a, name, at), String(a.block))}</li>
          )),
        )}
      </ul>
    </details>
  );
}
