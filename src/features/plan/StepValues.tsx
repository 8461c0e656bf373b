import { readJson } from "../../program/files/bounded.ts";
import { Fragment, useEffect, useMemo, useRef, useState } from "react";
import { handValuesOf, settableValues, type SettableValue } from "../../planning/hand-values.ts";
import type { Action, HandValues } from "../../planning/types.ts";
import type { PlanStep } from "../../planning/working-plan.ts";
import { Message } from "../../app/base/Message.tsx";
import { isSameData } from "../../app/base/same.ts";
import { TYPING } from "../../app/base/waits.ts";
import type { ValuesTried } from "../../app/calculation/part-plan.ts";
import { areaWords, differenceWords, timeWords, type PlanWords } from "../../app/fields/plan/plan-words.ts";
import { readText } from "../../program/values/field.ts";
import { issueText } from "../../app/calculation/issue-text.ts";
import { previewStock } from "./plan-place.ts";
import { StepValueField } from "./StepValueField.tsx";

interface Props {
  readonly words: PlanWords;
  readonly step: PlanStep;
  readonly index: number;
  readonly canChange: boolean;
  /** What the operation does with other values. */
  readonly preview: (values: HandValues) => Promise<ValuesTried | null>;
  readonly onSet: (values: HandValues) => void;
}

/** What is typed into the fields of an operation, by value, and the value that was typed last. */
interface Typed {
  readonly of: Action;
  readonly texts: Readonly<Record<string, string>>;
  readonly last: string | null;
}

/** Most findings that are named. */
const MOST_FINDINGS = 3;

/** What the typed values do, once it is known, and that it is not yet. */
function usePreview(typed: HandValues | null, preview: Props["preview"]): ValuesTried | null {
  const [known, know] = useState<{ readonly of: HandValues; readonly done: ValuesTried | null } | null>(null);
  useEffect(() => {
    if (!typed) return undefined;
    let isOld = false;
    const timer = setTimeout(() => {
      void preview(typed).then((done) => {
        if (isOld) return;
        know({ of: typed, done });
        previewStock(done?.tried.stock ?? null);
      });
    }, TYPING.rest);
    return () => {
      isOld = true;
      clearTimeout(timer);
      previewStock(null);
    };
    // The preview of an operation changes with its plan only, which changes the values, too.
    // oxlint-disable-next-line react/exhaustive-deps
  }, [typed]);
  return typed && known?.of === typed ? known.done : null;
}

/** The values of an operation with their reasons, to change them: what that does is shown before it is applied. */
export function StepValues({ words, step, index, canChange, preview, onSet }: Props) {
  const { t, work, language } = words,
    { steps: w } = t;
  const { action } = step.tried;
  const all = useMemo(() => settableValues(action), [action]);
  const [typed, type] = useState<Typed>({ of: action, texts: {}, last: null });
  // Another plan shows its own values.
  if (typed.of !== action) type({ of: action, texts: {}, last: null });
  const form = useRef<HTMLFormElement>(null),
    shown = useRef<HTMLDivElement>(null);
  const textOf = ({ q, value }: SettableValue) => typed.texts[q] ?? String(value);
  const readings = all.map((each) => ({ each, reading: readText(each.field, textOf(each)) }));
  const isValid = readings.every(({ reading }) => reading.value !== null);
  const now = handValuesOf(action);
  const next = Object.fromEntries(
    readings.flatMap(({ each, reading: { value } }) =>
      value === null || value === each.planned ? [] : [[each.q, value] as const],
    ),
  );
  const isChanged = isValid && !isSameData(next, now);
  const question = isChanged ? JSON.stringify(next) : "";
  // The same object while the values are the same.
  const asked = useMemo(() => (question === "" ? null : (readJson(question) as HandValues)), [question]);
  const seen = usePreview(asked, preview);
  useEffect(() => {
    if (seen) shown.current?.scrollIntoView({ block: "nearest" });
  }, [seen]);
  const put = (texts: Typed["texts"], last: string | null) => type({ of: action, texts, last });
  const leave = () => form.current?.querySelector<HTMLElement>("input, select")?.focus({ preventScroll: true });
  const set = (values: HandValues) => {
    leave();
    onSet(values);
  };
  const longer = seen ? seen.tried.seconds - step.tried.seconds : 0,
    leaves = seen ? step.tried.cut - seen.tried.cut : 0;
  const canApply = canChange && seen?.tried.works === true;
  const effect = (
    <div className="plan-preview" ref={shown}>
      <div className="plan-previewed" role="status" aria-busy={asked !== null && seen === null}>
        {asked && !seen && <span className="soft">{w.trying}</span>}
        {seen && (
          <>
            <b>{w.preview}</b>
            <span className="number">{timeWords(words, step.seconds + longer)}</span>
            <span>{differenceWords(words, { longer, leaves })}</span>
            {seen.issues.slice(0, MOST_FINDINGS).map((issue, i) => (
              <Message key={i} tone={issue.severity}>
                {issueText(work, language, issue, action.cycle)}
              </Message>
            ))}
            {!seen.tried.works && seen.tried.gouge > 0 && (
              <Message tone="error">{t.result.damage(areaWords(words, seen.tried.gouge))}</Message>
            )}
            {!seen.tried.works && <Message tone="error">{w.unusable}</Message>}
            {seen.tried.works && seen.issues.length === 0 && <span className="plan-good">{w.noFinding}</span>}
          </>
        )}
      </div>
      <div className="plan-step-ways">
        <button type="submit" className="button small primary" disabled={!canApply}>
          {w.apply}
        </button>
        <button
          type="button"
          className="button small"
          onClick={() => {
            leave();
            put({}, null);
          }}
        >
          {w.discard}
        </button>
      </div>
    </div>
  );
  const field = (each: SettableValue) => (
    <Fragment key={each.q}>
      <StepValueField
        words={words}
        action={action}
        settable={each}
        text={textOf(each)}
        isFixed={!canChange}
        onText={(text) => put({ ...typed.texts, [each.q]: text }, each.q)}
      />
      {typed.last === each.q && effect}
    </Fragment>
  );
  const reasoned = all.filter(({ reason }) => reason !== null),
    others = all.filter(({ reason }) => reason === null);
  return (
    <form
      ref={form}
      className="plan-values"
      aria-label={w.valuesLong(index + 1)}
      noValidate
      onSubmit={(event) => {
        event.preventDefault();
        if (canApply && asked) onSet(asked);
      }}
    >
      <h2>{w.values}</h2>
      {reasoned.map(field)}
      {others.length > 0 && (
        <details open={others.some(({ q }) => q in now) || undefined}>
          <summary>{w.otherValues(others.length)}</summary>
          {others.map(field)}
        </details>
      )}
      {Object.keys(now).length > 0 && (
        <div className="plan-step-ways">
          <button type="button" className="button small" disabled={!canChange} onClick={() => set({})}>
            {w.usePlanned}
          </button>
        </div>
      )}
    </form>
  );
}
