import type { ApproachRun } from "../../program/plane-types.ts";
import type { ApproachSpeech } from "../../view/approach/speech.ts";
import { useTexts } from "../settings/use-texts.ts";
import type { CutPlace } from "./plane-places.ts";

/** What the check of approach and departure found, and all named points in words. */
export function PlaneFindings({ approaches, places, chosen, choose, speech }: {
  readonly approaches: readonly ApproachRun[];
  readonly places: readonly CutPlace[];
  readonly chosen: CutPlace | null;
  readonly choose: (id: string | null) => void;
  readonly speech: ApproachSpeech;
}) {
  const t = useTexts().approach;
  if (approaches.length === 0) return null;
  return (
    <div className="lathe-more">
      <details name="plane-more">
        <summary className={places.length > 0 ? "lathe-faulty" : "lathe-clean"}>{places.length > 0 ? t.findings(String(places.length)) : t.clear}</summary>
        <ul>
          {places.map((p) => (
            <li key={p.id}>
              <button type="button" className="lathe-finding" aria-current={p === chosen} onClick={() => choose(p.id)}><span className="badge badge-finding">{p.mark}</span><span>{p.line}</span></button>
            </li>
          ))}
        </ul>
      </details>
      <details name="plane-more">
        <summary>{t.pointTable}</summary>
        <ul className="plane-point-list number small">
          {approaches.flatMap((a, i) => Object.entries(a.points).map(([name, at]) => <li key={`${i} ${name}`}>{t.pointAt(name, speech.point(at), String(a.block))}</li>))}
        </ul>
      </details>
    </div>
  );
}
