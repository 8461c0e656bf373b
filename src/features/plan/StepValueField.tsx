import { Suspense, useId } from "react";
import type { SettableValue } from "../../planning/hand-values.ts";
import type { Action } from "../../planning/types.ts";
import { Message } from "../../app/base/Message.tsx";
import { issueText } from "../../app/calculation/issue-text.ts";
import { LabelledInput } from "../../app/fields/number/LabelledInput.tsx";
import { ValueReason } from "../../app/fields/said/ValueReason.tsx";
import { settableWords, type PlanWords } from "../../app/fields/plan/plan-words.ts";
import { readText } from "../../program/values/field.ts";

interface Props {
  readonly words: PlanWords;
  readonly action: Action;
  readonly settable: SettableValue;
  readonly text: string;
  readonly isFixed: boolean;
  readonly onText: (text: string) => void;
}

/** A value of an operation, with its formula or what was planned. */
export function StepValueField({ words, action, settable, text, isFixed, onText }: Props) {
  const { name, label, unit, choices, planned } = settableWords(words, action, settable);
  const { issue } = readText(settable.field, text);
  const id = useId();
  const title = (
    <>
      <span className="number">{name}</span> {label}
    </>
  );
  const { reason } = settable;
  const hint = (reason !== null || planned !== "") && (
    <>
      {planned}{" "}
      {reason && (
        <Suspense>
          <ValueReason of={reason} />
        </Suspense>
      )}
    </>
  );
  if (choices)
    return (
      <div className="setup-field plan-value">
        <label htmlFor={id}>{title}</label>
        <select
          id={id}
          className="select"
          value={text}
          disabled={isFixed}
          aria-describedby={`${id}-hint`}
          onChange={(event) => onText(event.currentTarget.value)}
        >
          {choices.map((choice) => (
            <option key={choice.value} value={choice.value}>
              {choice.value} {choice.meaning}
            </option>
          ))}
        </select>
        {hint && (
          <p className="field-hint small soft" id={`${id}-hint`}>
            {hint}
          </p>
        )}
      </div>
    );
  return (
    <LabelledInput
      className="setup-field plan-value"
      label={title}
      unit={unit}
      text={text}
      readOnly={isFixed}
      onText={onText}
      hint={hint}
      aria-invalid={issue !== null}
      messages={issue && <Message tone="error">{issueText(words.work, words.language, issue, action.cycle)}</Message>}
    />
  );
}
