import type { ReactNode } from "react";
import { formatFixed } from "../../i18n/number.ts";
import { useOutcome } from "../engine/outcome.ts";
import { StripStatus } from "../findings/StripStatus.tsx";
import { useVerdict } from "../findings/use-findings.ts";
import { VerdictText } from "../findings/VerdictText.tsx";
import type { JobReading } from "../reading.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { chipArea, cutAtOnce, effectOf } from "./effect.ts";

/** What the values do, while they are typed: passes, real infeed, time, chip, what stays, and the proof. */
export function EffectStrip({ read }: { readonly read: JobReading }) {
  const { page: t, findings: words } = useTexts();
  const language = useSettings((s) => s.language);
  const shown = useOutcome((s) => s.shown);
  const dimmed = useOutcome((s) => s.dimmed);
  const verdict = useVerdict();
  const effect = shown && effectOf(shown);
  const chip = shown && chipArea(read, cutAtOnce(shown));
  const number = (value: number | null | undefined, decimals: number) =>
    value === null || value === undefined ? t.effect.unknown : formatFixed(language, value, decimals);
  const cell = (name: string, value: ReactNode, unit = "", className = "") => (
    <div className={`effect-cell ${className}`}>
      <dt>{name}</dt>
      <dd>
        <span className="number">{value}</span>
        {unit && <span className="soft small">{unit}</span>}
      </dd>
    </div>
  );
  const minutes = effect ? Math.floor(Math.round(effect.seconds) / 60) : 0;
  const seconds = effect ? effect.seconds - (minutes > 0 ? minutes * 60 : 0) : 0;

  return (
    <section className="effect" aria-label={t.effect.title}>
      <dl className={dimmed ? "dimmed" : ""}>
        {cell(t.effect.passes, number(effect?.passes, 0))}
        {cell(t.effect.infeed, number(effect?.infeed, 3), "mm")}
        {cell(t.effect.time, effect ? t.effect.duration(minutes, formatFixed(language, seconds, minutes > 0 ? 0 : 1)) : t.effect.unknown)}
        {cell(t.effect.chip, number(chip, 2), "mm²")}
        {cell(t.effect.residual, effect && effect.residual === 0 ? t.effect.none : number(effect?.residual, 2),
          effect?.residual ? "mm²" : "")}
        <div className="effect-cell proof">
          <dt>{words.verdict.title}</dt>
          <dd>
            <VerdictText verdict={verdict} reasons={verdict.state === "faults" ? 0 : 1} />
          </dd>
        </div>
      </dl>
      <StripStatus otherwise={dimmed ? t.effect.waiting : ""} />
    </section>
  );
}
