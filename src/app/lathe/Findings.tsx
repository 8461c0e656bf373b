import { formatNumber } from "../../i18n/number.ts";
import type { Simulation } from "../../sim/simulation.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { letterOf } from "./places.ts";
import type { PlaybackStore } from "./playback-store.ts";
import { placeText } from "./running.ts";

/** What the stock simulation found, and what stays with its reason; choosing one goes to its place. */
export function Findings({ simulation: { findings, proof, steps }, playback, chosen, choose }: {
  readonly simulation: Simulation;
  readonly playback: PlaybackStore;
  readonly chosen: string | null;
  readonly choose: (id: string) => void;
}) {
  const t = useTexts().lathe, language = useSettings(s => s.language), { residual } = proof;
  const item = (id: string, mark: string, line: string, go: () => void) => (
    <li key={id}>
      <button type="button" className="lathe-finding" aria-current={chosen === id} onClick={() => { choose(id); go(); }}>
        <span className={`badge badge-${id[0] === "f" ? "finding" : "residual"}`}>{mark}</span>
        <span>{line}</span>
      </button>
    </li>
  );
  return (
    <details className="lathe-findings" name="lathe-more">
      <summary>
        {findings.length === 0
          ? <span className="lathe-clean">{t.clear}</span>
          : <span className="lathe-faulty">{t.findingsCount(String(findings.length))}</span>}
        {residual.length > 0 && <span className="lathe-stays">{t.residualCount(String(residual.length))}</span>}
      </summary>
      {findings.length === 0 && <p className="soft">{t.noFindings}.</p>}
      {findings.length > 0 && (
        <ul aria-label={t.findings}>{findings.map((f, i) => {
          const { x, z } = placeText(language, f.place);
          return item(`f${i}`, String(i + 1), t.findingLine(t.findingNames[f.kind], x, z, String(f.block)),
            () => playback.dispatch({ do: "seek", position: { step: f.step, fraction: f.kind === "rapidInStock" ? 0 : 0.999 } }));
        })}</ul>
      )}
      {residual.length > 0 && (
        <ul aria-label={t.residualTitle}>{residual.map((r, i) => {
          const { x, z } = placeText(language, r.place);
          return item(`r${i}`, letterOf(i), t.residualLine(formatNumber(language, r.area, 2), x, z, t.reasons[r.reason]),
            () => playback.dispatch({ do: "seek", position: { step: steps.length, fraction: 0 } }));
        })}</ul>
      )}
    </details>
  );
}
