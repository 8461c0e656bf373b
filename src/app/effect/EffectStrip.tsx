import type { ReactNode } from "react";
import { formatFixed, formatNumber } from "../../i18n/number.ts";
import { Icon } from "../Icon.tsx";
import { useOutcome } from "../engine/outcome.ts";
import { showSection } from "../place.ts";
import { isOpen, useProblems } from "../problems/problems.ts";
import type { JobReading } from "../reading.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { chipArea, effectOf } from "./effect.ts";

/** What the values do, while they are typed: passes, real infeed, time, chip, what stays, and the proof. */
export function EffectStrip({ read }: { readonly read: JobReading }) {
  const { page: t, dialog: { done: { open } } } = useTexts();
  const language = useSettings((s) => s.language);
  const shown = useOutcome((s) => s.shown);
  const dimmed = useOutcome((s) => s.dimmed);
  const problems = useProblems();
  const effect = shown && effectOf(shown);
  const chip = effect && chipArea(read, effect.infeed);
  const number = (value: number | null | undefined, decimals: number) =>
    value === null || value === undefined ? t.effect.unknown : formatFixed(language, value, decimals);
  const cell = (name: string, value: ReactNode, unit = "", className = "") => (
    <div className={`effect-cell ${className}`}>
      <dt>{name}</dt>
      <dd><span className="number">{value}</span>{unit && <span className="soft small"> {unit}</span>}</dd>
    </div>
  );
  const minutes = effect ? Math.floor(Math.round(effect.seconds) / 60) : 0;
  const seconds = effect ? effect.seconds - (minutes > 0 ? minutes * 60 : 0) : 0;
  const allOpen = problems.every(isOpen);
  const worst = allOpen && problems.length > 0 ? "info" : problems[0]?.issue.severity;
  const bad = !dimmed && effect !== null && (effect.gouge > 0 || effect.rapid > 0 || effect.holder);
  const proof = !effect || dimmed ? t.effect.unknown
    : effect.gouge > 0 ? t.effect.gouge(formatNumber(language, effect.gouge, 2))
    : effect.rapid > 0 ? t.effect.rapid(formatNumber(language, effect.rapid, 2))
    : effect.holder ? t.effect.holder : t.effect.clean;

  return (
    <section className="effect" aria-label={t.effect.title}>
      <dl className={dimmed ? "dimmed" : ""}>
        {cell(t.effect.passes, number(effect?.passes, 0))}
        {cell(t.effect.infeed, number(effect?.infeed, 3), "mm")}
        {cell(t.effect.time, effect ? t.effect.duration(minutes, formatFixed(language, seconds, minutes > 0 ? 0 : 1)) : t.effect.unknown)}
        {cell(t.effect.chip, number(chip, 2), "mm²")}
        {cell(t.effect.residual, effect && effect.residual === 0 ? t.effect.none : number(effect?.residual, 2), effect && effect.residual > 0 ? "mm²" : "")}
        <div className={`effect-cell proof ${bad ? "bad" : effect && !dimmed ? "good" : ""}`}>
          <dt>{t.effect.proof}</dt>
          <dd>{effect && !dimmed && <Icon name={bad ? "error" : "check"} />}<span>{proof}</span></dd>
        </div>
      </dl>
      <p className="effect-status" role="status">
        {problems.length > 0 && (
          <button type="button" className={`problem-button ${worst ?? ""}`} onClick={() => showSection("problems")}>
            <Icon name={worst ?? "info"} /> {allOpen ? open(problems.length) : t.problem.count(problems.length)}
          </button>
        )}
        {dimmed && problems.length === 0 && <span className="small">{t.effect.waiting}</span>}
      </p>
    </section>
  );
}
