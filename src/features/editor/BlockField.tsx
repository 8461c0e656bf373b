import { useId, useRef, useState, type ReactNode } from "react";
import type { Statement } from "../../nc/statement.ts";
import { sumOf } from "../../program/values/field.ts";
import { useNumberEntry } from "../../app/fields/dialog/use-number-entry.ts";
import { inScreenWriting } from "../../app/fields/dialog/write-value.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { closeStep } from "../../app/document/steps.ts";
import type { WordField } from "../../app/fields/blocks/field.ts";

interface Props {
  readonly field: WordField;
  readonly statement: Statement;
  readonly change: (next: Statement, field: string) => void;
  /** The way to its page of the guide. */
  readonly more: ReactNode;
}

/** What was typed, and what the block said then: when the block says something else by now, that counts. */
interface Typed {
  readonly text: string;
  readonly said: string;
}

/** One word of a block. Each keystroke that can be read changes the text of the block; leaving the field ends the step of undo. */
export function BlockField({ field, statement, change, more }: Props) {
  const t = useTexts().editor;
  const id = useId();
  const input = useRef<HTMLInputElement>(null);
  const language = useSettings((s) => s.language);
  const [typed, setTyped] = useState<Typed | null>(null);
  const said = field.read(statement);
  const shown = typed && typed.said === said ? typed.text : said;
  const name = typeof field.name === "string" ? t.fields[field.name] : t.fields.wordOf(field.name.word);
  const wrong = typed !== null && typed.said === said && field.write(statement, typed.text) === null;

  const write = (text: string) => {
    const next = field.write(statement, text);
    setTyped({ text, said: next ? field.read(next) : said });
    if (next) change(next, field.id);
  };
  const leave = () => {
    closeStep();
    if (!wrong) {
      const sum = field.numeric && typed ? sumOf(typed.text) : null;
      if (sum !== null) write(sum);
      setTyped(null);
    }
  };
  const { onKeyDown, onTyped } = useNumberEntry(input, shown, write);

  if (field.choices) {
    const choices: Readonly<Record<string, string>> = t.choices;
    return (
      <div className="block-field" data-word={field.id}>
        <span className="block-name">
          <label htmlFor={id}>{name}</label>
          {more}
        </span>
        <select id={id} className="select" value={said} onChange={(event) => {
          closeStep();
          write(event.target.value);
          closeStep();
        }}>
          {field.choices.map((choice) => (
            <option key={choice} value={choice}>{choice === "" ? t.none : (choices[choice] ?? choice)}</option>
          ))}
        </select>
      </div>
    );
  }
  const { incremental } = field;
  return (
    <div className={`block-field${field.wide ? " wide" : ""}`} data-word={field.id}>
      <span className="block-name">
        <label htmlFor={id}>{name}</label>
        {more}
      </span>
      <span className="block-value">
        <input id={id} ref={input} type="text" className={`input${field.wide ? "" : " number"}`}
          inputMode={field.numeric ? "decimal" : "text"} {...(field.numeric && { "data-number": "words" })} autoComplete="off"
          spellCheck={false} maxLength={500} aria-invalid={wrong} aria-describedby={`${id}-unit ${id}-wrong`}
          value={field.numeric ? inScreenWriting(language, shown) : shown} onChange={(event) => {
          onTyped();
          write(event.currentTarget.value);
        }} onBlur={leave} {...(field.numeric && { onKeyDown })} />
        <span className="soft small" id={`${id}-unit`}>{field.unit}</span>
        {incremental && (
          <button type="button" className="button incremental" aria-pressed={incremental.read(statement)} aria-label={t.incrementalOf(name)}
            title={t.incremental} disabled={said === ""} onClick={() => {
            closeStep();
            change(incremental.write(statement, !incremental.read(statement)), `${field.id} incremental`);
            closeStep();
          }}>
            I
          </button>
        )}
      </span>
      <div id={`${id}-wrong`} className="block-wrong" role="status">
        {wrong && (
          <p className="field-message error">
            <Icon name="error" /> {t.notReadable}
          </p>
        )}
      </div>
    </div>
  );
}
