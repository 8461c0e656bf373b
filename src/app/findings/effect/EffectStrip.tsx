import { useEffect, type ReactNode } from "react";
import { formatFixed } from "../../../i18n/number.ts";
import { Checking, useChecking } from "../../calculation/Checking.tsx";
import { useLengths } from "../../calculation/lengths.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { StripStatus } from "../StripStatus.tsx";
import { useVerdict } from "../use-findings.ts";
import { VerdictText } from "../VerdictText.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { followComparing } from "./compared.ts";
import { durationText } from "../../base/clock-text.ts";
import { areaDecimals, type ComparedNumber } from "./changes.ts";
import { effectNow } from "./effect.ts";
import { PinButton } from "./Pinned.tsx";
import { TimeName } from "./TimeName.tsx";
import { FaultsChange, useChanges } from "./EffectChanges.tsx";
import { SpokenEffect } from "./SpokenEffect.tsx";

/** One number of the strip. */
interface EffectCell {
  readonly name: ReactNode;
  readonly value: ReactNode;
  readonly unit?: string;
  /** The number that is compared with the state before. */
  readonly compared?: ComparedNumber;
  /** The first to go where there is no room for all numbers. */
  readonly isLeast?: boolean;
}

/** The present result, and its numbers that every work shows. */
export function useEffectCells() {
  const t = useTexts().page.effect;
  const lengths = useLengths(),
    { language } = lengths;
  const shown = useOutcome((s) => s.pictured);
  const proved = useOutcome((s) => s.shown);
  const effect = shown && effectNow(shown, proved);
  const number = (value: number | null | undefined, decimals: number) =>
    value === null || value === undefined ? t.unknown : formatFixed(language, value, decimals);
  const { residual } = effect ?? {};
  const cells = {
    passes: { name: t.passes, value: number(effect?.passes, 0), compared: "passes" },
    time: {
      name: <TimeName name={t.time} />,
      value: effect ? durationText(t.duration, language, effect.seconds) : t.unknown,
      compared: "time",
    },
    residual: {
      name: t.residual,
      value: residual ? lengths.fixedArea(residual, areaDecimals(residual)) : residual === 0 ? t.none : t.unknown,
      unit: residual ? lengths.words("mm²") : "",
      compared: "residual",
    },
  } as const satisfies Record<string, EffectCell>;
  return { shown, effect, number, cells };
}

/** Effect of the values while they are typed: the numbers of the work, and the verdict. */
export function EffectStrip({
  name,
  cells,
  waiting = "",
}: {
  readonly name: string;
  readonly cells: readonly EffectCell[];
  /** Said while the numbers are older than the values. */
  readonly waiting?: string;
}) {
  const t = useTexts().findings;
  const dimmed = useOutcome((s) => s.dimmed);
  const checking = useChecking();
  const verdict = useVerdict();
  const { changed } = useChanges();
  useEffect(followComparing, []);
  return (
    <section className="effect" aria-label={name} aria-busy={checking.now} data-checking={checking.seen}>
      <dl className={dimmed ? "dimmed" : ""}>
        {cells.map(({ name: cell, value, unit = "", compared, isLeast }, i) => (
          <div key={i} className={`effect-cell${compared === "residual" ? " stays" : ""}${isLeast ? " least" : ""}`}>
            <dt>{cell}</dt>
            <dd {...(compared && changed(compared))}>
              <span className="number">{value}</span>
              {unit && <span className="soft small"> {unit}</span>}
            </dd>
          </div>
        ))}
        <div className="effect-cell proof">
          <dt>
            {t.verdict.title} <FaultsChange />
          </dt>
          <dd>
            <VerdictText verdict={verdict} reasons={verdict.state === "faults" ? 0 : 1} />
            {checking.seen && <Checking />}
          </dd>
        </div>
      </dl>
      <PinButton />
      <StripStatus otherwise={dimmed ? waiting : ""} />
      <SpokenEffect />
    </section>
  );
}
