import { useEffect, useId, useRef } from "react";
import { readText, sumOf, type Field } from "../../../program/values/field.ts";
import { FieldMessage } from "../dialog/FieldMessage.tsx";
import { inScreenWriting } from "../dialog/write-value.ts";
import { useNumberEntry } from "../dialog/use-number-entry.ts";
import { Icon } from "../../base/Icon.tsx";
import { usePlace } from "../../place/place.ts";
import { useFindings } from "../../findings/use-findings.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { closeStep } from "../../document/steps.ts";
import { useTyping } from "../../base/typing.ts";

interface Props {
  readonly name: string;
  readonly unit: string;
  readonly text: string;
  readonly onText: (text: string) => void;
  /** Its id is the place that findings name; also how the keyboard is sent here. */
  readonly field: Field;
  /** What an empty field asks for, calmly: it is not done wrong, only not done yet. */
  readonly ask?: string;
  /** What holds as long as the field is empty. */
  readonly proposal?: string | undefined;
}

/** What is wrong with a typed number, in the words of the set-up; null when it can be used. */
function wrongNumber(field: Field, text: string): "missing" | "notANumber" | "negative" | "positive" | null {
  const found = readText(field, text).issue;
  if (!found) return null;
  if (found.code === "missing") return "missing";
  if (found.code !== "outOfRange") return "notANumber";
  return found.data.min === 0 ? "negative" : "positive";
}

/** One number of the set-up: typed text goes to the work at each keystroke, sums are worked out when the field is left. */
export function NumberField({ name, unit, text: said, onText, field, ask, proposal }: Props) {
  const t = useTexts();
  const id = useId();
  const input = useRef<HTMLInputElement>(null);
  const language = useSettings((s) => s.language);
  const [text, type] = useTyping(field.id, said, onText);
  const { onKeyDown, onTyped } = useNumberEntry(input, text, type);
  const asked = usePlace((p) => (p.field === field.id ? p.focus : 0));
  const problems = useFindings().filter((p) => p.at === field.id);
  const found = wrongNumber(field, text);
  const asking = found === "missing" && ask !== undefined;
  const open = found === "missing" && proposal !== undefined;
  const isProposed = proposal !== undefined && text.trim() === "";
  const wrong = asking || open ? null : found;

  useEffect(() => {
    if (asked === 0) return;
    input.current?.focus();
    input.current?.select();
  }, [asked]);

  const commit = () => {
    const sum = sumOf(text);
    if (sum !== null) onText(sum);
    closeStep();
  };

  return (
    <div className="setup-field">
      <label htmlFor={id}>{name}</label>
      <span className="setup-value">
        <input id={id} ref={input} className="input number" type="text" data-number="words" inputMode="decimal" autoComplete="off"
          spellCheck={false} maxLength={200} aria-invalid={wrong !== null || problems.some((p) => p.issue.severity === "error")}
          aria-describedby={`${id}-unit ${id}-proposed ${id}-wrong`}
          {...(isProposed && { placeholder: inScreenWriting(language, proposal) })} value={inScreenWriting(language, text)} onBlur={commit}
          onKeyDown={onKeyDown} onChange={(e) => {
          onTyped();
          type(e.currentTarget.value);
        }} />
        <span className="soft small" id={`${id}-unit`}>{unit}</span>
      </span>
      {isProposed && (
        <p className="setup-proposed small soft" id={`${id}-proposed`}>
          <span>{t.setup.proposed}: {inScreenWriting(language, proposal)}</span>
          <button type="button" className="button small" aria-label={t.setup.keepLong(name, inScreenWriting(language, proposal))}
            onClick={() => {
              closeStep();
              onText(proposal);
              closeStep();
            }}
          >
            {t.setup.keep}
          </button>
        </p>
      )}
      <div id={`${id}-wrong`} className="setup-wrong" role="status">
        {wrong && (
          <p className="field-message error">
            <Icon name="error" /> {t.setup.wrong[wrong]}
          </p>
        )}
        {asking && (
          <p className="field-message info">
            <Icon name="info" /> {ask}
          </p>
        )}
        {!wrong && problems.map((p, i) => <FieldMessage key={i} problem={p} decimals={3} onTake={(n) => onText(String(n))} />)}
      </div>
    </div>
  );
}
