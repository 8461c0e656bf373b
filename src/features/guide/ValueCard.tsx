import type { ReactNode } from "react";
import type { GuideTexts } from "../../i18n/en/guide.ts";
import type { Language } from "../../i18n/languages.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import { LEAST_SEEN, type ShownChange } from "../../report/guide/shown-effect.ts";
import { NO_AREA } from "../../app/findings/effect/effect.ts";
import { useIssueText } from "../../app/calculation/issue-text.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { CutPicture } from "./CutPicture.tsx";
import { keepFocus } from "./keep-focus.ts";
import type { ComparedValue } from "./compared-values.ts";
import { durationText, type DurationWords } from "../../app/base/clock-text.ts";
import { Message } from "../../app/base/Message.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The effect of a value compared with the default, in words. */
function changeText(
  t: GuideTexts,
  duration: DurationWords,
  language: Language,
  { passes, seconds, residual, rz, part, way }: ShownChange,
): string {
  const number = (value: number, decimals: number) => formatNumber(language, Math.abs(value), decimals);
  const said = [
    ...(passes === 0 ? [] : [t.change.passes(passes)]),
    ...(Math.abs(seconds) < LEAST_SEEN.seconds
      ? []
      : [t.change.seconds(durationText(duration, language, Math.abs(seconds)), seconds > 0)]),
    ...(Math.abs(residual) < NO_AREA ? [] : [t.change.residual(number(residual, 2), residual > 0)]),
    ...(rz === null || Math.abs(rz) < LEAST_SEEN.rz ? [] : [t.change.rz(number(rz, 1), rz > 0)]),
    ...(part < NO_AREA ? [] : [t.change.part(number(part, 2))]),
    ...(way < LEAST_SEEN.way || passes !== 0 || part >= NO_AREA ? [] : [t.change.way(number(way, 2))]),
  ];
  return said.length === 0 ? t.change.none : `${said.join(" · ")}`;
}

interface Props {
  readonly tried: ComparedValue;
  readonly box: Box;
  /** Label in front of the value: Q463, D. */
  readonly letter: string;
  readonly text: string;
  readonly unit: string;
  /** Small, default or large. */
  readonly size: string | null;
  /** Owner of the value, if it has one. */
  readonly whose: string | null;
  readonly meaning?: ReactNode;
  /** Applies the value to the work; null if it does not fit there. */
  readonly take: (() => void) | null;
  /** Shows all paths of the program, not those of its cycles alone. */
  readonly whole?: boolean;
}

/** One value with its picture and its numbers. */
export function ValueCard({ tried, box, letter, text, unit, size, whose, meaning, take, whole = false }: Props) {
  const t = useTexts("guide");
  const advice = useTexts("advice");
  const { duration } = useTexts("first").page.effect;
  const language = useSettings((s) => s.language);
  const issueText = useIssueText();
  const { effect, change, outcome } = tried,
    { run } = outcome;
  const number = (n: number, decimals: number) => formatNumber(language, n, decimals);
  const facts: readonly (readonly [string, string])[] = [
    ...(run.operations.length === 0 ? [] : [[t.numbers.passes, number(effect.passes, 0)] as const]),
    ...(run.operations.length !== 1 ? [] : [[t.numbers.infeed, t.millimetres(number(effect.infeed, 3))] as const]),
    [t.numbers.seconds, durationText(duration, language, effect.seconds)],
    [t.numbers.residual, t.area(number(effect.residual < NO_AREA ? 0 : effect.residual, 2))],
    ...(effect.rz === null ? [] : [[t.numbers.rz, t.microns(number(effect.rz, 1))] as const]),
  ];
  const [issue] = effect.issues;
  return (
    <li className="value-card" data-usual={tried.isUsual || undefined}>
      <h3>
        {size && <span className="value-size">{size}</span>}
        <span className="number value-shown">
          {text}
          {unit && ` ${unit}`}
        </span>
        {whose && <span className="small soft">{whose}</span>}
      </h3>
      {meaning && <p>{meaning}</p>}
      <CutPicture
        outcome={outcome}
        box={box}
        stock={outcome.simulation.final}
        steps={whole ? run.steps : run.steps.filter((s) => s.operation !== null)}
        name={`${t.values.picture(letter, text)}. ${facts.map((fact) => fact.join(" ")).join(", ")}`}
      />
      <dl className="value-facts">
        {facts.map(([name, fact]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd className="number">{fact}</dd>
          </div>
        ))}
      </dl>
      {(change || tried.isUsual) && (
        <p className="value-change">{change ? changeText(t, duration, language, change) : t.change.usual}</p>
      )}
      {take && (
        <button
          type="button"
          className="button value-take"
          onClick={(event) => {
            keepFocus(event.currentTarget, "section");
            take();
          }}
        >
          {advice.take(`${letter} = ${text}`)}
        </button>
      )}
      {issue && <Message tone={issue.severity}>{issueText(issue)}</Message>}
    </li>
  );
}
