import type { ReactNode } from "react";
import { formatFixed, formatNumber } from "../../i18n/number.ts";
import { effectOf } from "../effect/effect.ts";
import { useOutcome } from "../engine/outcome.ts";
import { Icon } from "../Icon.tsx";
import { showSection } from "../place.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { useFindings } from "./use-findings.ts";

/** What the whole program does: operations, passes, tool changes, time, what stays, and the proof. */
export function TotalsStrip() {
  const t = useTexts();
  const language = useSettings((s) => s.language);
  const shown = useOutcome((s) => s.shown);
  const dimmed = useOutcome((s) => s.dimmed);
  const findings = useFindings();
  const effect = shown && effectOf(shown);
  const words = t.page.effect;
  const number = (value: number | undefined, decimals: number) => (value === undefined ? words.unknown : formatFixed(language, value, decimals));
  const tools = shown?.run.steps.reduce((n, step, i, all) => (step.tool.T === all[i - 1]?.tool.T ? n : n + 1), 0);
  const cell = (name: string, value: ReactNode, unit = "") => (
    <div className="effect-cell">
      <dt>{name}</dt>
      <dd><span className="number">{value}</span>{unit && <span className="soft small"> {unit}</span>}</dd>
    </div>
  );
  const seconds = effect ? Math.round(effect.seconds) : 0;
  const milled = shown !== null && shown.run.plane.length > 0 && shown.run.steps.length === 0;
  const cuts = findings.filter((f) => f.issue.code === "approachCutsContour" || f.issue.code === "approachValueCutsContour" || f.issue.code === "approachBlocked").length;
  const bad = effect !== null && !dimmed && (cuts > 0 || effect.gouge > 0 || effect.rapid > 0 || effect.holder);
  const proof = milled && !dimmed ? (shown.run.approaches.length === 0 ? words.unknown : cuts > 0 ? t.approach.findings(String(cuts)) : t.approach.clear)
    : !effect || dimmed ? words.unknown
    : effect.gouge > 0 ? words.gouge(formatNumber(language, effect.gouge, 2))
    : effect.rapid > 0 ? words.rapid(formatNumber(language, effect.rapid, 2))
    : effect.holder ? words.holder : words.clean;
  const proven = effect !== null && !dimmed && (!milled || shown.run.approaches.length > 0);
  const worst = findings[0]?.issue.severity;
  return (
    <section className="effect" aria-label={t.editor.total}>
      <dl className={dimmed ? "dimmed" : ""}>
        {cell(t.editor.operations, number(shown?.run.operations.length, 0))}
        {cell(t.editor.toolChanges, number(tools, 0))}
        {cell(words.passes, number(effect?.passes, 0))}
        {cell(words.time, effect ? words.duration(Math.floor(seconds / 60), formatFixed(language, seconds % 60, 0)) : words.unknown)}
        {cell(words.residual, effect && effect.residual === 0 ? words.none : number(effect?.residual, 2), effect && effect.residual > 0 ? "mm²" : "")}
        {cell(t.editor.blocks, number(shown?.run.program.blocks, 0))}
        <div className={`effect-cell proof ${bad ? "bad" : proven ? "good" : ""}`}>
          <dt>{words.proof}</dt>
          <dd>{(bad || proven) && <Icon name={bad ? "error" : "check"} />}<span>{proof}</span></dd>
        </div>
      </dl>
      <p className="effect-status" role="status">
        {findings.length > 0 && (
          <button type="button" className={`problem-button ${worst ?? ""}`} onClick={() => showSection("findings")}>
            <Icon name={worst ?? "info"} /> {t.page.problem.count(findings.length)}
          </button>
        )}
      </p>
    </section>
  );
}
