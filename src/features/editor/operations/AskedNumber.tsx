import { useId, useState } from "react";
import { readText, type Field } from "../../../program/values/field.ts";
import { NumberInput } from "../../../app/fields/number/NumberInput.tsx";
import { useBegunSign } from "../../../app/fields/number/use-begun-sign.ts";
import { Message } from "../../../app/base/Message.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";

interface Props {
  readonly name: string;
  readonly unit: string;
  readonly field: Field;
  readonly text: string;
  readonly onText: (text: string) => void;
}

/** True if the typed number is valid; a sum is, too. */
export const isUsable = (field: Field, text: string): boolean => readText(field, text).issue === null;

/** Selector of the numbers without a usable value. */
export const OPEN_NUMBER = "[data-open=true]";

/** One number of a dialog that is not part of the work yet. */
export function AskedNumber({ name, unit, field, text, onText }: Props) {
  const t = useTexts().setup;
  const id = useId();
  const wrong = !isUsable(field, text);
  // A field that opened empty is to be filled in; it becomes an error when a value was erased.
  const [isTouched, touch] = useState(false);
  const { isBegun, onTyped, onLeft } = useBegunSign(text);
  const isEmpty = text.trim() === "";
  const isCalm = isEmpty && !isTouched;
  return (
    <label htmlFor={id}>
      <span>{name}</span>
      <span className="asked-value">
        <NumberInput
          id={id}
          text={text}
          onText={(typed) => {
            touch(true);
            onTyped(typed);
            onText(typed);
          }}
          onLeave={onLeft}
          selects
          aria-invalid={wrong && !isCalm && !isBegun}
          data-open={wrong || undefined}
          aria-describedby={`${id}-unit`}
        />
        <span className="soft small" id={`${id}-unit`}>
          {unit}
        </span>
      </span>
      {wrong && !isBegun && (
        <Message as="span" tone={isCalm ? "info" : "error"} className="small" role="status">
          {isEmpty ? t.wrong.missing : t.wrong.notANumber}
        </Message>
      )}
    </label>
  );
}
