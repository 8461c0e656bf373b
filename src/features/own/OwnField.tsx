import { useId, useRef, type ReactNode } from "react";
import { sumOf } from "../../program/values/field.ts";
import type { OwnProblem } from "../../program/edits/own-cycle.ts";
import { useNumberEntry } from "../../app/fields/dialog/use-number-entry.ts";
import { inScreenWriting } from "../../app/fields/dialog/write-value.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { closeStep } from "../../app/document/steps.ts";

/** What is wrong with a field, read out when it changes. What is only not there yet is said calmly. */
export function OwnProblems({ id, problems, text }: { readonly id: string; readonly problems: readonly OwnProblem[];
  readonly text: string })
{
  const t = useTexts();
  const { own } = useTexts("tables");
  return (
    <div id={id} className="own-wrong" role="status">
      {problems.map((problem) => {
        const tone = text.trim() === "" ? "info" : "error";
        return (
          <p key={problem.code} className={`field-message ${tone}`}>
            <Icon name={tone} />
            <span>
              <span className="unseen">{t.findings.severities[tone]}:</span>
              {own.problems[problem.code](problem.text)}
            </span>
          </p>
        );
      })}
    </div>
  );
}

interface Props {
  readonly className: string;
  readonly label: ReactNode;
  /** Its full name, where the label is short. */
  readonly name?: string;
  readonly text: string;
  readonly problems: readonly OwnProblem[];
  readonly onText: (text: string) => void;
  /** A number: sums are worked out when it is left. */
  readonly numeric?: boolean;
  readonly whole?: boolean;
  readonly hint?: string;
}

/** One field of a description. Each keystroke goes to the list; leaving it ends the step of undo. */
export function OwnField({ className, label, name, text, problems, onText, numeric = false, whole = false, hint }: Props) {
  const id = useId();
  const input = useRef<HTMLInputElement>(null);
  const language = useSettings((s) => s.language);
  const { onKeyDown, onTyped } = useNumberEntry(input, text, onText);
  const leave = () => {
    const sum = numeric ? sumOf(text) : null;
    if (sum !== null) onText(sum);
    closeStep();
  };
  return (
    <div className={`own-field ${className}`}>
      <label htmlFor={id}>{label}</label>
      <input id={id} ref={input} type="text" className={`input${numeric || whole ? " number" : ""}`}
        inputMode={numeric ? "decimal" : whole ? "numeric" : "text"} {...((numeric || whole) && { "data-number": "words" })}
        autoComplete="off" spellCheck={false} maxLength={500} aria-label={name} aria-invalid={text.trim() !== "" && problems.length > 0}
        aria-describedby={`${id}-wrong`} placeholder={hint} value={numeric ? inScreenWriting(language, text) : text} onChange={(event) => {
        onTyped();
        onText(event.currentTarget.value);
      }} onBlur={leave} {...(numeric && { onKeyDown })} />
      <OwnProblems id={`${id}-wrong`} problems={problems} text={text} />
    </div>
  );
}
