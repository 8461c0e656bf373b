import type { ApproachRun } from "../../../program/tools/plane-types.ts";
import type { ApproachWords } from "../../../view/approach/words.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

/** All named points of approaches and departures in words. */
export function PointTable({
  approaches,
  speech,
}: {
  readonly approaches: readonly ApproachRun[];
  readonly speech: ApproachWords;
}) {
  const t = useTexts().approach;
  if (approaches.length === 0) return null;
  return (
    <details>
      <summary>{t.pointTable}</summary>
      <ul className="plane-point-list number small">
        {approaches.flatMap((a, i) =>
          Object.entries(a.points).map(([name, at]) => (
            <li key={`${i} ${name}`}>{t.pointAt(name, speech.point(at), String(a.block))}</li>
          )),
        )}
      </ul>
    </details>
  );
}
