import { inScreenWriting } from "../../../i18n/number.ts";
import { useEffect, useRef } from "react";
import { readText, type Field } from "../../../program/values/field.ts";
import { FieldMessage } from "../number/FieldMessage.tsx";
import { LabelledInput } from "../number/LabelledInput.tsx";
import { Message } from "../../base/Message.tsx";
import { usePlace } from "../../place/place.ts";
import { useFindings } from "../../findings/use-findings.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { closeStep } from "../../document/steps.ts";
import { useTyping } from "../../base/typing.ts";
import type { SetupPlace } from "../../../program/job/setup-places.ts";
import { OtherProposal } from "./OtherProposal.tsx";

interface Props {
  readonly name: string;
  readonly unit: string;
  readonly text: string;
  readonly onText: (text: string) => void;
  /** Its id is the place that findings name, and the target for the focus. */
  readonly field: Field;
  /** Hint for an empty field that is not filled in yet. */
  readonly ask?: string;
  /** Value used while the field is empty. */
  readonly proposal?: string | undefined;
  /** The field of the set-up that it is: another proposal for its value is shown beside it. */
  readonly place?: SetupPlace;
}

/** Problem of a typed number; null if it is valid. */
function wrongNumber(field: Field, text: string): "missing" | "notANumber" | "negative" | "positive" | null {
  const found = readText(field, text).issue;
  if (!found) return null;
  if (found.code === "missing") return "missing";
  if (found.code !== "outOfRange") return "notANumber";
  return found.data.min === 0 ? "negative" : "positive";
}

/** One number of the set-up. Each keystroke updates the work; sums are evaluated on blur. */
export function NumberField({ name, unit, text: said, onText, field, ask, proposal, place }: Props) {
  const t = useTexts();
  const input = useRef<HTMLInputElement>(null);
  const language = useSettings((s) => s.language);
  const [text, type] = useTyping(field.id, said, onText);
  const asked = usePlace((p) => (p.field === field.id ? p.focus : 0));
  const problems = useFindings().filter((p) => p.at === field.id);
  const found = wrongNumber(field, text);
  const asking = found === "missing" && ask !== undefined;
  const wrong = asking || (found === "missing" && proposal !== undefined) ? null : found;
  const proposed = proposal !== undefined && text.trim() === "" ? inScreenWriting(language, proposal) : undefined;

  const take = (value: string) => {
    closeStep();
    onText(value);
    closeStep();
    input.current?.focus();
  };
  useEffect(() => {
    if (asked === 0) return;
    input.current?.focus();
    input.current?.select();
  }, [asked]);

  return (
    <LabelledInput
      ref={input}
      className="setup-field"
      label={name}
      unit={unit}
      text={text}
      onText={type}
      onLeave={closeStep}
      onKeyDown={(event) => {
        if (event.key !== "Enter" || proposal === undefined || proposed === undefined) return;
        event.preventDefault();
        take(proposal);
      }}
      placeholder={proposed}
      aria-invalid={wrong !== null || problems.some((p) => p.issue.severity === "error")}
      hint={
        proposal !== undefined && proposed !== undefined ? (
          <>
            <span>
              {t.setup.proposed}: {proposed}
            </span>
            <button
              type="button"
              className="button small"
              aria-label={t.setup.keepLong(name, proposed)}
              onClick={() => take(proposal)}
            >
              {t.setup.keep}
            </button>
          </>
        ) : (
          place && <OtherProposal place={place} take={take} />
        )
      }
      messages={
        <>
          {wrong && <Message tone="error">{t.setup.wrong[wrong]}</Message>}
          {asking && <Message tone="info">{ask}</Message>}
          {!wrong &&
            problems.map((p, i) => <FieldMessage key={i} problem={p} decimals={3} onTake={(n) => onText(String(n))} />)}
        </>
      }
    />
  );
}
