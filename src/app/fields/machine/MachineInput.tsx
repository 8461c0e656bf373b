import { useId, useRef } from "react";
import { sumOf } from "../../../program/values/field.ts";
import { useNumberEntry } from "../dialog/use-number-entry.ts";
import { inScreenWriting } from "../dialog/write-value.ts";
import { Icon } from "../../base/Icon.tsx";
import { useSettings } from "../../base/settings/settings.ts";

interface Props {
  readonly name: string;
  readonly unit: string;
  readonly text: string;
  readonly onText: (text: string) => void;
  /** What is wrong with it, in words. */
  readonly wrong: string | null;
}

/** One number of the machine: taken at each key, sums worked out when it is left. */
export function MachineInput({ name, unit, text, onText, wrong }: Props) {
  const id = useId();
  const input = useRef<HTMLInputElement>(null);
  const language = useSettings((s) => s.language);
  const { onKeyDown, onTyped } = useNumberEntry(input, text, onText);
  return (
    <div className="setup-field">
      <label htmlFor={id}>{name}</label>
      <span className="setup-value">
        <input id={id} ref={input} className="input number" type="text" inputMode="decimal" autoComplete="off" spellCheck={false}
          maxLength={60} aria-invalid={wrong !== null} aria-describedby={`${id}-unit ${id}-wrong`} value={inScreenWriting(language, text)}
          onBlur={() => {
            const sum = sumOf(text);
            if (sum !== null) onText(sum);
          }} onKeyDown={(event) => {
          // Enter in a form of the settings would close them.
          if (event.key === "Enter") event.preventDefault();
          else onKeyDown(event);
        }} onChange={(event) => {
          onTyped();
          onText(event.currentTarget.value);
        }} />
        <span className="soft small" id={`${id}-unit`}>{unit}</span>
      </span>
      <div id={`${id}-wrong`} className="setup-wrong" role="status">
        {wrong !== null && (
          <p className="field-message error">
            <Icon name="error" /> {wrong}
          </p>
        )}
      </div>
    </div>
  );
}
