import type { ReactNode } from "react";
import type { OwnProblem } from "../../program/edits/own-cycle.ts";
import { LabelledInput } from "../../app/fields/number/LabelledInput.tsx";
import { Message } from "../../app/base/Message.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { closeStep } from "../../app/document/steps.ts";

/** The faults of a field. A merely missing value is shown without alarm. */
export function OwnProblems({ problems, text }: { readonly problems: readonly OwnProblem[]; readonly text: string }) {
  const t = useTexts();
  const { own } = useTexts("tables");
  const tone = text.trim() === "" ? "info" : "error";
  return problems.map((problem) => (
    <Message key={problem.code} tone={tone}>
      <span>
        <span className="unseen">{t.findings.severities[tone]}:</span>
        {own.problems[problem.code](problem.text)}
      </span>
    </Message>
  ));
}

interface Props {
  readonly className: string;
  readonly label: ReactNode;
  /** Its full name, where the label is short. */
  readonly name?: string;
  readonly text: string;
  readonly problems: readonly OwnProblem[];
  readonly onText: (text: string) => void;
  readonly kind?: "number" | "whole" | "text";
  readonly hint?: string;
}

/** One field of a description. Each keystroke goes to the list; leaving the field ends the step of undo. */
export function OwnField({ className, label, name, text, problems, onText, kind = "text", hint }: Props) {
  return (
    <LabelledInput
      className={`own-field ${className}`}
      label={label}
      text={text}
      onText={onText}
      onLeave={closeStep}
      {...(kind === "whole" ? { kind: "typed", keypad: "words", inputMode: "numeric" } : { kind })}
      aria-label={name}
      aria-invalid={text.trim() !== "" && problems.length > 0}
      placeholder={hint}
      messages={<OwnProblems problems={problems} text={text} />}
    />
  );
}
