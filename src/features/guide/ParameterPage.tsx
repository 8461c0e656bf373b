import { isRecalled, type Param } from "../../cycles/params.ts";
import { activeSteps } from "../../cycles/active-steps.ts";
import type { Cycle } from "../../cycles/define.ts";
import type { CycleNumber, ParamTextId } from "../../cycles/index.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { Numbers } from "../../view/help/lettering.ts";
import { unitOf } from "../../app/fields/dialog/write-value.ts";
import { cycleGivens } from "../../app/calculation/cycle-givens.ts";
import { HelpPicture } from "../../app/pictures/help/HelpPicture.tsx";
import { Icon } from "../../app/base/Icon.tsx";
import { readJob } from "../../app/document/reading.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { AdviceItems } from "./AdviceItems.tsx";
import { GlossaryText, GlossaryList, GlossaryScope } from "../../app/fields/said/GlossaryText.tsx";
import { showGuide } from "../../app/place/place.ts";
import { guideSources } from "./guide-source.ts";
import { StartingValues } from "./StartingValues.tsx";
import { termsOf } from "./terms.ts";
import { useAdviceOn } from "../../app/fields/said/use-advice.ts";
import { useMistakes } from "./use-mistakes.ts";
import { ValuePictures } from "./ValuePictures.tsx";

interface Props {
  readonly cycle: Cycle;
  readonly q: string;
  readonly param: Param;
}

/** Meaning, unit and limits. */
function Facts({ cycle, q, param }: Props) {
  const t = useTexts("guide");
  const { dialog, cycles } = useTexts();
  const language = useSettings((s) => s.language);
  const number = (value: number) => formatNumber(language, value, param.decimals);
  const unit = dialog.units[unitOf(param, true)];
  const perMinute = param.kind === "feed" && !param.perMinute ? `, ${dialog.units.perMinute}` : "";
  const across =
    param.kind === "diameter" || param.kind === "oversizeDiameter"
      ? t.onDiameter
      : param.kind === "radial"
        ? t.onRadius
        : null;
  const rows: readonly (readonly [string, string])[] = [
    [t.asks, cycles.kinds[param.kind]],
    ...(param.choices ? [] : [[t.unit, unit === "" ? t.noUnit : unit + perMinute] as const]),
    [t.range, param.choices ? param.choices.join(" / ") : dialog.range(number(param.range[0]), number(param.range[1]))],
    [t.printed, `${q} = ${number(param.example)}`],
  ];
  return (
    <section className="guide-facts" aria-label={t.facts}>
      <dl>
        {rows.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd className="number">{value}</dd>
          </div>
        ))}
      </dl>
      {across && <p>{across}</p>}
      {param.optional && <p>{t.mayBeLeft}</p>}
      {param.reserved && <p>{t.reserved}</p>}
      {(isRecalled(cycle) || param.evidence !== "A") && (
        <p className="soft small">{isRecalled(cycle) ? dialog.recalled : dialog.evidence.parameter}</p>
      )}
      {!isRecalled(cycle) && param.evidence === "A" && param.rangeEvidence !== "A" && !param.choices && (
        <p className="soft small">{dialog.evidence.range}</p>
      )}
    </section>
  );
}

/** The two numbered sequences, with the steps that the value affects. */
function ActsIn({ cycle, param }: Omit<Props, "q">) {
  const t = useTexts("guide");
  const words = useTexts().cycles.of[cycle.number as CycleNumber];
  const acts = activeSteps(cycle, param);
  const isNowhere = acts.rough.length + acts.finish.length === 0;
  return (
    <section className="guide-acts" aria-label={t.acts.title}>
      <h2>{t.acts.title}</h2>
      <p className="soft">{isNowhere ? t.acts.none : t.acts.lead}</p>
      {(["rough", "finish"] as const)
        .filter((run) => words[run].length > 0)
        .map((run) => (
          <div key={run}>
            <h3>{t.acts[run]}</h3>
            <ol className="acts-list">
              {words[run].map((text, i) => (
                <li key={text} data-acts={acts[run].includes(i + 1) || undefined}>
                  <span className="number">{i + 1}</span> <span>{text}</span>
                  {acts[run].includes(i + 1) && <b className="acts-here">{t.acts.here}</b>}
                </li>
              ))}
            </ol>
          </div>
        ))}
      {words.rough.length > 0 && (
        <button type="button" className="button" onClick={() => showGuide("guide", String(cycle.number))}>
          <Icon name="play" /> {t.acts.watch}
        </button>
      )}
    </section>
  );
}

/** The advice on the value in the open work. */
function ParameterAdvice({ cycle, q }: Pick<Props, "cycle" | "q">) {
  const t = useTexts("advice");
  const on = useSettings((s) => s.advice);
  const advice = useAdviceOn(cycle.number, q);
  if (!on || advice.length === 0) return null;
  return (
    <section aria-label={t.title}>
      <h2>{t.title}</h2>
      <p className="soft small">{t.lead}</p>
      <AdviceItems cycle={cycle.number} advice={advice} />
    </section>
  );
}

/** The page of one parameter of a cycle. */
export function ParameterPage({ cycle, q, param }: Props) {
  const t = useTexts("guide");
  const glossary = useTexts("glossary");
  const mistakes = useMistakes(param);
  const { params, cycles } = useTexts();
  const language = useSettings((s) => s.language);
  const words = params[param.text as ParamTextId];
  const all = Object.keys(cycle.params);
  const at = all.indexOf(q),
    [before, after] = [all[at - 1], all[at + 1]];
  const [source] = guideSources(cycle);
  const read = source && readJob(source.job);
  const said = [words.explanation, ...mistakes];
  const go = (other: string) => showGuide("guide", String(cycle.number), other);
  return (
    <GlossaryScope texts={said}>
      <header className="guide-head">
        <p className="soft">
          <span className="number">{cycle.number}</span> {cycles.of[cycle.number as CycleNumber].name}
        </p>
        <h1>
          <span className="number prompt-q">{q}</span> {words.prompt}
        </h1>
        <p>
          <GlossaryText text={words.explanation} />
        </p>
        <div className="guide-turns">
          <button
            type="button"
            className="button"
            disabled={!before}
            aria-label={before && t.previousLong(before)}
            onClick={() => before && go(before)}
          >
            <Icon name="up" /> {t.previous}
          </button>
          <button
            type="button"
            className="button"
            disabled={!after}
            aria-label={after && t.nextLong(after)}
            onClick={() => after && go(after)}
          >
            <Icon name="down" /> {t.next}
          </button>
        </div>
      </header>
      <div className="guide-lead">
        <Facts cycle={cycle} q={q} param={param} />
        {read && !cycle.acts && (
          <div className="guide-help">
            <HelpPicture
              cycle={cycle}
              values={read.reading.values as Numbers | null}
              given={cycleGivens(read)}
              activeQ={q}
              language={language}
            />
          </div>
        )}
      </div>
      <ParameterAdvice cycle={cycle} q={q} />
      {param.kind === "feed" && <StartingValues cycle={cycle} only={q} />}
      {!cycle.acts && <ValuePictures cycle={cycle} q={q} param={param} />}
      <div className="guide-columns">
        <section className="guide-mistakes" aria-label={t.mistakes}>
          <h2>{t.mistakes}</h2>
          <GlossaryList texts={mistakes} />
          <h2>{t.terms}</h2>
          <ul className="guide-terms">
            {termsOf(param).map((term) => (
              <li key={term}>
                <button
                  type="button"
                  className="guide-term"
                  title={glossary[term].text}
                  onClick={() => showGuide("glossary", term)}
                >
                  {glossary[term].name}
                </button>
              </li>
            ))}
          </ul>
        </section>
        {!cycle.acts && <ActsIn cycle={cycle} param={param} />}
      </div>
    </GlossaryScope>
  );
}
