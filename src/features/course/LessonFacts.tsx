import { Suspense } from "react";
import { operationsPlayed, type StepRange } from "../../course/playback-range.ts";
import { formatFixed, formatNumber } from "../../i18n/number.ts";
import type { Outcome } from "../../app/calculation/outcome.ts";
import { effectOf } from "../../app/findings/effect/effect.ts";
import { useLengths } from "../../app/calculation/lengths.ts";
import { LoadScale } from "../../app/pictures/load/LoadScale.tsx";
import { useLoadDrawing } from "../../app/pictures/load/use-drawing.ts";
import {
  loadPlaceText,
  loadValue,
  useGreatest,
  useMeasuredRun,
  type LoadQuantity,
} from "../../app/pictures/load/use-load.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { durationText } from "../../app/base/clock-text.ts";

/** The colour map: its scale, and the greatest value with its place. */
function ColourMapFacts({ of, run }: { readonly of: LoadQuantity; readonly run: Outcome["run"] }) {
  const t = useTexts("load");
  const lengths = useLengths(run);
  const told = useMeasuredRun(run);
  const drawing = useLoadDrawing(told, of);
  const worst = useGreatest(told, of)?.worst ?? null;
  return (
    <section className="lesson-load" aria-label={t.names[of]}>
      <p>
        <b>{t.names[of]}</b> <span className="soft small">{t.abouts[of]}</span>
      </p>
      {drawing && worst && <LoadScale of={of} drawing={drawing} />}
      <p className="small" role="status">
        {worst ? (
          <>
            <span className="soft">{worst.limited && of === "speed" ? t.least : t.greatest}</span>{" "}
            <span className="number">
              <b>{loadValue(t, lengths, of, worst.value)}</b> {loadPlaceText(t, lengths, worst)}
            </span>
          </>
        ) : drawing ? (
          t.nothing
        ) : (
          t.working
        )}
      </p>
    </section>
  );
}

/** Results for the values of a page: passes, real infeed, time, residual material; and the scale of a colour map. */
export function LessonFacts({
  outcome,
  played,
  told,
  old,
  spoken,
}: {
  readonly outcome: Outcome;
  readonly played: StepRange;
  readonly told: LoadQuantity | null;
  /** These are the results of the previous value. */
  readonly old: boolean;
  /** A value was changed on this page: what came of it is announced. */
  readonly spoken: boolean;
}) {
  const {
    page: { effect: t },
  } = useTexts();
  const language = useSettings((s) => s.language);
  const { run } = outcome;
  const calls = operationsPlayed(run.operations, played);
  const passes = calls.reduce((sum, { plan }) => sum + plan.passes, 0);
  const [cutting, ...others] = calls.map(({ plan }) => plan).filter(({ infeed, passes: n }) => infeed > 0 && n > 0);
  const seconds = run.steps.slice(played.first, played.last + 1).reduce((sum, step) => sum + step.seconds, 0);
  const { residual } = effectOf(outcome);
  const infeedText = (infeed: number) => formatFixed(language, infeed, 3);
  const facts: readonly (readonly [name: string, value: string])[] = [
    ...(passes > 0 ? [[t.passes, formatNumber(language, passes, 0)] as const] : []),
    // Thread passes get shallower, so the deepest one is shown. Calls with different infeeds show none.
    ...(cutting && others.every(({ infeed }) => infeedText(infeed) === infeedText(cutting.infeed))
      ? [[t.infeed, `${infeedText(cutting.infeed)} ${cutting.thread ? "mm" : t.infeedUnit}`] as const]
      : []),
    [t.time, durationText(t.duration, language, seconds)],
    ...(calls.length > 0 && residual !== null
      ? [[t.residual, residual === 0 ? t.none : `${formatNumber(language, residual, 3)}\u00a0mm²`] as const]
      : []),
  ];
  return (
    <>
      <dl className={`lesson-facts${old ? " dimmed" : ""}`}>
        {facts.map(([name, value]) => (
          <div key={name}>
            <dt className="soft small">{name}</dt>
            <dd className="number">{value}</dd>
          </div>
        ))}
      </dl>
      <p className="unseen" role="status">
        {spoken && !old && facts.map((fact) => fact.join(" ")).join(", ")}
      </p>
      {told && (
        <Suspense>
          <ColourMapFacts of={told} run={run} />
        </Suspense>
      )}
    </>
  );
}
