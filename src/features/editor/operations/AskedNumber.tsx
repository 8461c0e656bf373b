import { useId, useRef } from "react";
import { readText, sumOf, type Field } from "../../../program/values/field.ts";
import { useNumberEntry } from "../../../app/fields/dialog/use-number-entry.ts";
import { inScreenWriting } from "../../../app/fields/dialog/write-value.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";

interface Props {
  readonly name: string;
  readonly unit: string;
  readonly field: Field;
  readonly text: string;
  readonly onText: (text: string) => void;
}

/** True when a typed number can be used, a sum too. */
export const isUsable = (field: Field, text: string): boolean => readText(field, text).issue === null;

/** One number of a dialog that is not part of the work yet. */
export function AskedNumber({ name, unit, field, text, onText }: Props) {
  const t = useTexts().setup;
  const id = useId();
  const input = useRef<HTMLInputElement>(null);
  const language = useSettings((s) => s.language);
  const { onKeyDown, onTyped } = useNumberEntry(input, text, onText);
  const wrong = !isUsable(field, text);
  const commit = () => {
    const sum = sumOf(text);
    if (sum !== null) onText(sum);
  };
  return (
    <label htmlFor={id}>
      <span>{name}</span>
      <span className="asked-value">
        <input id={id} ref={input} className="input number" type="text" data-number="words" inputMode="decimal" autoComplete="off"
          spellCheck={false} maxLength={200} aria-invalid={wrong} aria-describedby={`${id}-unit`} value={inScreenWriting(language, text)}
          onBlur={commit} onKeyDown={onKeyDown} onFocus={(event) => event.currentTarget.select()} onChange={(event) => {
          onTyped();
          onText(event.currentTarget.value);
        }} />
        <span className="soft small" id={`${id}-unit`}>{unit}</span>
      </span>
      {wrong && <span className="field-message error small" role="status">{text.trim() === "" ? t.wrong.missing : t.wrong.notANumber}
      </span>}
    </label>
  );
}
