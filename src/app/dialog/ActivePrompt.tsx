import { useId, useLayoutEffect, useRef, useState, type RefObject } from "react";
import type { Param } from "../../cycles/params.ts";
import type { ParamTextId } from "../../cycles/index.ts";
import { formatNumber } from "../../i18n/number.ts";
import { setPrompt } from "../edits.ts";
import { usePlace } from "../place.ts";
import { isOpen, type Entry } from "../findings/entry.ts";
import { usePromptFindings } from "../findings/use-findings.ts";
import { usePrompted } from "../prompted.ts";
import type { JobReading } from "../reading.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { closeStep } from "../store.ts";
import { ChoiceInput } from "./ChoiceInput.tsx";
import { FieldMessage } from "./FieldMessage.tsx";
import { promptsOf, unconfirmed, unitOf } from "./prompts.ts";
import { onPromptKey } from "./use-prompt-keys.ts";
import { ValueInput, type ValueField } from "./ValueInput.tsx";

interface Props {
  readonly read: JobReading;
  readonly q: string;
  readonly param: Param;
  readonly ownKeypad: boolean;
  readonly field: RefObject<ValueField | null>;
}

/** The open prompt, large: question, value, unit, range, what is wrong, what it does. */
export function ActivePrompt({ read, q, param, ownKeypad, field }: Props) {
  const t = useTexts();
  const id = useId();
  const language = useSettings((s) => s.language);
  const every = usePromptFindings();
  const problems = every.filter((p) => p.at === q);
  const elsewhere = every.filter((p) => p.at !== null && p.at !== q && "other" in p.issue.data && p.issue.data.other === q);
  const card = useRef<HTMLElement>(null);
  const focus = usePlace((p) => p.focus);
  useLayoutEffect(() => {
    card.current?.scrollIntoView?.({ block: "nearest" });
  }, [q, focus]);
  const [explained, explain] = useState<string | null>(null);
  const words = t.params[param.text as ParamTextId];
  const all = promptsOf(read.cycle);
  const text = read.draft[q] ?? "";
  const unit = t.dialog.units[unitOf(param, read.job.perRevolution)];
  const doubtful = unconfirmed(param.evidence) ? "parameter" : unconfirmed(param.rangeEvidence) && !param.choices ? "range" : null;
  const labelOf = (at: string) => {
    const other = read.cycle.params[at];
    return t.dialog.value(at, other ? t.params[other.text as ParamTextId].label : "");
  };
  const untouched = usePlace((p) => p.before.trim() === "");
  const calm = (problem: Entry) => isOpen(problem) && (untouched || problem.issue.code === "unknownParameter");
  const inBlock = usePrompted((p) => p.block !== null);
  const name = t.dialog.value(q, words.prompt);
  const take = (value: string) => {
    closeStep();
    setPrompt(q, value);
    closeStep();
    field.current?.focus();
  };
  const number = (n: number) => formatNumber(language, n, param.decimals);

  return (
    <section className="active-prompt" ref={card} aria-label={t.dialog.active} onKeyDown={onPromptKey}>
      <header>
        <span className="number prompt-q">{q}</span>
        <h2>{words.prompt}</h2>
        <span className="soft small prompt-position">{t.dialog.position(all.indexOf(q) + 1, all.length)}</span>
      </header>
      {param.choices ? (
        <ChoiceInput
          q={q} param={param} text={text} name={name} describedBy={`${id}-about`}
          meanings={"choices" in words ? words.choices : {}}
        />
      ) : (
        <div className="value-row">
          <ValueInput
            q={q} text={text} name={name} describedBy={`${id}-range ${id}-about`} ownKeypad={ownKeypad} field={field}
            invalid={problems.some((p) => p.issue.severity === "error" && !calm(p))}
          />
          <span className="unit number">{unit}</span>
          {param.kind === "feed" && (
            <button type="button" className="button" aria-label={t.dialog.autoLong} onClick={() => take("FAUTO")}>FAUTO</button>
          )}
        </div>
      )}
      <p className="range small soft" id={`${id}-range`}>
        {!param.choices && (
          <span>
            {t.dialog.rangeLabel} <span className="number">{t.dialog.range(number(param.range[0]), number(param.range[1]))}</span>
          </span>
        )}
        {param.incremental && <span>{t.dialog.incremental}</span>}
        {param.optional && <span>{t.dialog.optional}</span>}
        {param.reserved && <span>{t.dialog.reserved}</span>}
        {doubtful && (
          <button type="button" className="evidence" aria-expanded={explained === q} onClick={() => explain(explained === q ? null : q)}>
            {t.dialog.evidence.mark}
          </button>
        )}
      </p>
      <div className="about" id={`${id}-about`} tabIndex={0} role="group" aria-label={t.dialog.aboutPrompt(q)}>
        <div role="status" aria-label={t.findings.title}>
          {problems.map((problem, i) => (
            <FieldMessage key={i} problem={problem} calm={calm(problem)} decimals={param.decimals} onTake={(n) => take(String(n))} parameterField={!inBlock} />
          ))}
          {elsewhere.map((problem) => (
            <FieldMessage key={problem.at} problem={problem} place={labelOf(problem.at ?? "")} decimals={param.decimals} />
          ))}
        </div>
        {doubtful && explained === q && <p className="evidence-text small">{t.dialog.evidence[doubtful]}</p>}
        <p className="explanation">{words.explanation}</p>
      </div>
    </section>
  );
}
