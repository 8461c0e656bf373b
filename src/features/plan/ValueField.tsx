import { inScreenWriting } from "../../i18n/number.ts";
import { useState } from "react";
import { anyNumber, readText } from "../../program/values/field.ts";
import { LabelledInput } from "../../app/fields/number/LabelledInput.tsx";
import { Message } from "../../app/base/Message.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { closeStep } from "../../app/document/steps.ts";

interface Props {
  readonly name: string;
  readonly unit: string;
  readonly range: readonly [least: number, most: number];
  /** Undefined while the field is empty. */
  readonly value: number | undefined;
  /** The value that counts for an empty field. */
  readonly usual?: number;
  readonly onValue: (value: number | undefined) => void;
}

/** A number that is stored as a number: only one in its range is passed on, the typed text stays. */
export function ValueField({ name, unit, range, value, usual, onValue }: Props) {
  const language = useSettings((s) => s.language);
  const field = { ...anyNumber, id: `plan ${name}`, range, optional: true };
  const textOf = (n: number | undefined) => (n === undefined ? "" : String(n));
  const [typed, type] = useState({ text: textOf(value), value });
  // A value from elsewhere, such as undo, replaces the text.
  if (typed.value !== value) type({ text: textOf(value), value });
  const { issue } = readText(field, typed.text);
  return (
    <LabelledInput
      className="setup-field"
      label={name}
      unit={unit}
      text={typed.text}
      {...(usual !== undefined && { placeholder: inScreenWriting(language, String(usual)) })}
      onText={(text) => {
        const read = readText(field, text);
        const next = read.issue ? value : (read.value ?? undefined);
        type({ text, value: next });
        if (next !== value) onValue(next);
      }}
      onLeave={closeStep}
      aria-invalid={issue !== null}
      messages={
        issue && (
          <Message tone="error">
            {inScreenWriting(language, String(range[0]))} … {inScreenWriting(language, String(range[1]))}
          </Message>
        )
      }
    />
  );
}
