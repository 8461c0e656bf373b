import { useEffect, type ReactNode } from "react";
import { formatFixed } from "../../../i18n/number.ts";
import { Checking, useChecking } from "../../calculation/Checking.tsx";
import { useOutcome } from "../../calculation/outcome.ts";
import { StripStatus } from "../StripStatus.tsx";
import { useVerdict } from "../use-findings.ts";
import { VerdictText } from "../VerdictText.tsx";
import type { JobReading } from "../../document/reading.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { followComparing } from "./compared.ts";
import { durationText } from "../../base/clock-text.ts";
import { areaDecimals, type ComparedNumber } from "./changes.ts";
import { chipArea, cutAtOnce, effectNow } from "./effect.ts";
import { PinButton } from "./Pinned.tsx";
import { TimeName } from "./TimeName.tsx";
import { FaultsChange, useChanges } from "./EffectChanges.tsx";
import { SpokenEffect } from "./SpokenEffect.tsx";

/** Effect of the values while they are typed: passes, actual infeed, time, chip, residual material, and the verdict. */
export function EffectStrip({ read }: { readonly read: JobReading }) {
  const texts = useTexts(),
    { page: t, findings: words } = texts;
  const language = useSettings((s) => s.language);
  const shown = useOutcome((s) => s.pictured);
  const proved = useOutcome((s) => s.shown);
  const dimmed = useOutcome((s) => s.dimmed);
  const checking = useChecking();
  const verdict = useVerdict();
  const effect = shown && effectNow(shown, proved);
  // A thread has no chip of one size: it changes from pass to pass.
  const cuts = read.cycle.group !== "thread";
  const chip = shown && chipArea(read, cutAtOnce(shown));
  const number = (value: number | null | undefined, decimals: number) =>
    value === null || value === undefined ? t.effect.unknown : formatFixed(language, value, decimals);
  useEffect(followComparing, []);
  const { changed } = useChanges();
  const cell = (name: ReactNode, value: ReactNode, unit = "", compared: ComparedNumber | null = null) => (
    <div className={`effect-cell${compared === "residual" ? " stays" : compared === "chip" ? " chip-size" : ""}`}>
      <dt>{name}</dt>
      <dd {...(compared && changed(compared))}>
        <span className="number">{value}</span>
        {unit && <span className="soft small"> {unit}</span>}
      </dd>
    </div>
  );

  return (
    <section className="effect" aria-label={t.effect.title} aria-busy={checking.now} data-checking={checking.seen}>
      <dl className={dimmed ? "dimmed" : ""}>
        {cell(t.effect.passes, number(effect?.passes, 0), "", "passes")}
        {cell(t.effect.infeed, number(effect?.infeed, 3), "mm", "infeed")}
        {cell(
          <TimeName name={t.effect.time} />,
          effect ? durationText(t.effect.duration, language, effect.seconds) : t.effect.unknown,
          "",
          "time",
        )}
        {cuts && cell(t.effect.chip, number(chip, areaDecimals(chip ?? 0)), "mm²", "chip")}
        {cell(
          t.effect.residual,
          effect && effect.residual === 0
            ? t.effect.none
            : number(effect?.residual, areaDecimals(effect?.residual ?? 0)),
          effect?.residual ? "mm²" : "",
          "residual",
        )}
        <div className="effect-cell proof">
          <dt>
            {words.verdict.title} <FaultsChange />
          </dt>
          <dd>
            <VerdictText verdict={verdict} reasons={verdict.state === "faults" ? 0 : 1} />
            {checking.seen && <Checking />}
          </dd>
        </div>
      </dl>
      <PinButton />
      <StripStatus otherwise={dimmed ? t.effect.waiting : ""} />
      <SpokenEffect />
    </section>
  );
}
