import type { ParamTextId } from "../../cycles/index.ts";
import type { Cycle } from "../../cycles/define.ts";
import type { Param } from "../../cycles/params.ts";
import type { GuideTexts } from "../../i18n/en/guide.ts";
import type { Language } from "../../i18n/languages.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { ShownChange } from "../../report/guide/shown-effect.ts";
import { NO_AREA } from "../effect/effect.ts";
import { CycleInWork, useIssueText } from "../issue-text.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { unitOf } from "../dialog/write-value.ts";
import { CutPicture } from "./CutPicture.tsx";
import { takeValue, useTaking } from "./take-value.ts";
import { useAdviceTexts } from "./use-advice.ts";
import { useGuideTexts } from "./use-guide-texts.ts";
import { useTriedValues, type TriedValue, type TriedValues } from "./use-tried-values.ts";

/** Differences below these are none: seconds, µm. */
const NO_TIME = 0.05;
const NO_HEIGHT = 0.05;

/** What a value changes against the usual one, in words. */
function changeText(t: GuideTexts, language: Language, { passes, seconds, residual, rz, part }: ShownChange): string {
  const number = (value: number, decimals: number) => formatNumber(language, Math.abs(value), decimals);
  const said = [
    ...(passes === 0 ? [] : [t.change.passes(passes)]),
    ...(Math.abs(seconds) < NO_TIME ? [] : [t.change.seconds(number(seconds, 1), seconds > 0)]),
    ...(Math.abs(residual) < NO_AREA ? [] : [t.change.residual(number(residual, 2), residual > 0)]),
    ...(rz === null || Math.abs(rz) < NO_HEIGHT ? [] : [t.change.rz(number(rz, 1), rz > 0)]),
    ...(part < NO_AREA ? [] : [t.change.part(number(part, 2))]),
  ];
  return said.length === 0 ? t.change.none : `${said.join(" · ")}`;
}

interface CardProps {
  readonly q: string;
  readonly param: Param;
  readonly of: TriedValues;
  readonly tried: TriedValue;
  readonly size: string | null;
  /** Takes the value over into the work; null where it cannot go there. */
  readonly take: (() => void) | null;
}

/** One value with its picture and its numbers. */
function ValueCard({ q, param, of, tried, size, take }: CardProps) {
  const t = useGuideTexts();
  const advice = useAdviceTexts();
  const { dialog: { units }, params } = useTexts();
  const language = useSettings((s) => s.language);
  const issueText = useIssueText();
  const { value, effect, change, outcome } = tried;
  const number = (n: number, decimals: number) => formatNumber(language, n, decimals);
  const text = value === "auto" ? "FAUTO" : number(value, param.decimals);
  const unit = value === "auto" ? "" : units[unitOf(param, true)];
  const words = params[param.text as ParamTextId];
  const meaning = "choices" in words && value !== "auto" ? words.choices[value] : undefined;
  const facts: readonly (readonly [string, string])[] = [
    [t.numbers.passes, number(effect.passes, 0)],
    [t.numbers.infeed, t.millimetres(number(effect.infeed, 3))],
    [t.numbers.seconds, t.seconds(number(effect.seconds, 1))],
    [t.numbers.residual, t.area(number(effect.residual < NO_AREA ? 0 : effect.residual, 2))],
    ...(effect.rz === null ? [] : [[t.numbers.rz, t.microns(number(effect.rz, 1))] as const]),
  ];
  const [issue] = effect.issues;
  return (
    <li className="value-card" data-usual={tried.isUsual || undefined}>
      <h3>
        {size && <span className="value-size">{size}</span>}
        <span className="number value-shown">{text}{unit && ` ${unit}`}</span>
        {value === of.usual && <span className="small soft">{of.isOwn ? t.values.yours : t.values.printed}</span>}
      </h3>
      {meaning && <p>{meaning}</p>}
      <CutPicture outcome={outcome} box={of.box} stock={outcome.simulation.final}
        steps={outcome.run.steps.filter((s) => s.operation !== null)}
        name={`${t.values.picture(q, text)}. ${facts.map((fact) => fact.join(" ")).join(", ")}`} />
      <dl className="value-facts">
        {facts.map(([name, fact]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd className="number">{fact}</dd>
          </div>
        ))}
      </dl>
      {(change || tried.isUsual) && <p className="value-change">{change ? changeText(t, language, change) : t.change.usual}</p>}
      {take && <button type="button" className="button value-take" onClick={take}>{advice.take(`${q} = ${text}`)}</button>}
      {issue && <p className={`field-message ${issue.severity}`}>{issueText(issue)}</p>}
    </li>
  );
}

/** A parameter at a small, a usual and a large value, or at each of its choices, run by the kernel. */
export function ValuePictures({ cycle, q, param }: { readonly cycle: Cycle; readonly q: string; readonly param: Param }) {
  const t = useGuideTexts();
  const { values, working } = useTriedValues(cycle, q);
  const canTake = useTaking(cycle.number)(q) && values?.isOwn === true;
  const sizes = [t.values.small, t.values.usual, t.values.large];
  const needed = Object.entries(values?.needed ?? {}).map(([other, value]) => `${other} = ${value}`).join(", ");
  return (
    <section className="guide-values" aria-label={t.values.title} aria-busy={working}>
      <h2>{t.values.title}</h2>
      <p className="soft">{values?.isOwn ? t.values.ownLead : t.values.lead}{needed && ` ${t.values.needed(needed)}`}</p>
      {values === undefined && <p className="guide-working soft" role="status">{t.values.working}</p>}
      {values === null && <p className="soft">{t.values.none}</p>}
      {values && (
        <CycleInWork value={cycle.number}>
          <ol className="value-cards">
            {values.tried.map((tried, i) => (
              <ValueCard key={String(tried.value)} q={q} param={param} of={values} tried={tried}
                take={canTake && tried.value !== values.usual
                  ? () => void takeValue(cycle.number, q, tried.value)
                  : null} size={param.choices || values.tried.length !== sizes.length ? null : sizes[i] ?? null} />
            ))}
          </ol>
          {values.tried.length === 1 && <p className="soft">{t.values.none}</p>}
        </CycleInWork>
      )}
    </section>
  );
}
