import { useId, useState, type ReactNode } from "react";
import type { Statement } from "../../nc/statement.ts";
import { LabelledInput } from "../../app/fields/number/LabelledInput.tsx";
import { Message } from "../../app/base/Message.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { closeStep } from "../../app/document/steps.ts";
import type { WordField } from "../../app/fields/blocks/field.ts";

interface Props {
  readonly field: WordField;
  readonly statement: Statement;
  readonly change: (next: Statement, field: string) => void;
  /** The link to its page of the guide. */
  readonly more: ReactNode;
  /** X is a diameter: the block turns. */
  readonly isTurned: boolean;
}

/** The typed text, and the block's text at that time: if the block has changed since, its text wins. */
interface Typed {
  readonly text: string;
  readonly said: string;
}

/**
 * One word of a block. Each readable keystroke changes the text of the block; leaving the field ends the step of undo.
 */
export function BlockField({ field, statement, change, more, isTurned }: Props) {
  const t = useTexts().editor;
  const id = useId();
  const [typed, setTyped] = useState<Typed | null>(null);
  const said = field.read(statement);
  const shown = typed && typed.said === said ? typed.text : said;
  const plain = typeof field.name === "string" ? t.fields[field.name] : t.fields.wordOf(field.name.word);
  const name = isTurned && field.id === "X" ? `${plain} ⌀` : plain;
  const wrong = typed !== null && typed.said === said && field.write(statement, typed.text) === null;

  const write = (text: string) => {
    const next = field.write(statement, text);
    setTyped({ text, said: next ? field.read(next) : said });
    if (next) change(next, field.id);
  };
  if (field.choices) {
    const choices: Readonly<Record<string, string>> = t.choices;
    return (
      <div className="block-field">
        <span className="field-name">
          <label htmlFor={id}>{name}</label>
          {more}
        </span>
        <select
          id={id}
          className="select"
          data-word={field.id}
          value={said}
          onChange={(event) => {
            closeStep();
            write(event.target.value);
            closeStep();
          }}
        >
          {field.choices.map((choice) => (
            <option key={choice} value={choice}>
              {choice === "" ? t.none : (choices[choice] ?? choice)}
            </option>
          ))}
        </select>
      </div>
    );
  }
  const { incremental, numeric, wide } = field;
  return (
    <LabelledInput
      className={`block-field${wide ? " wide" : ""}`}
      label={name}
      more={more}
      unit={field.unit ?? ""}
      kind={numeric ? "number" : wide ? "text" : "typed"}
      data-word={field.id}
      text={shown}
      onText={write}
      onLeave={() => {
        closeStep();
        if (!wrong) setTyped(null);
      }}
      aria-invalid={wrong}
      messages={wrong && <Message tone="error">{t.notReadable}</Message>}
      button={
        incremental && (
          <button
            type="button"
            className="button incremental"
            aria-pressed={incremental.read(statement)}
            aria-label={t.incrementalOf(name)}
            title={t.incremental}
            disabled={said === ""}
            onClick={() => {
              closeStep();
              change(incremental.write(statement, !incremental.read(statement)), `${field.id} incremental`);
              closeStep();
            }}
          >
            I
          </button>
        )
      }
    />
  );
}
