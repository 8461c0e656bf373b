import { useId, useState, type KeyboardEvent } from "react";
import { flushSync } from "react-dom";
import type { Language } from "../../i18n/languages.ts";
import { sumOf } from "../../program/values/field.ts";
import type { RowField } from "../../program/job/contour-rows.ts";
import { isPlainNumber, minus } from "../../app/fields/dialog/number-entry.ts";
import { inScreenWriting } from "../../app/fields/dialog/write-value.ts";
import { closeStep } from "../../app/document/steps.ts";
import { whileTyping } from "../../app/base/typing.ts";

/** What stands grey in an empty field: where a coordinate stays, or what was solved. */
export interface Shown {
  readonly text: string;
  readonly name: string;
  readonly solved: boolean;
}

interface Props {
  readonly row: string;
  readonly field: RowField;
  readonly name: string;
  readonly language: Language;
  readonly text: string;
  readonly shown: Shown | null;
  readonly wrong: boolean;
  readonly describedBy: string;
  /** What is typed is told to the drawing and the table behind the picture of its digit: they are long. */
  readonly isLong: boolean;
  readonly onText: (text: string) => void;
  /** The I key of the coordinate; absent where a value cannot be incremental. */
  /** The T key: tangential to the element before. */
  readonly onTangent?: () => void;
  readonly incremental?: { readonly on: boolean; readonly name: string; readonly toggle: () => void };
}

/** One number of the contour table, with its I key where it is a coordinate. */
export function ContourCell({ row, field, name, language, text: told, shown, wrong, describedBy, isLong, onText, onTangent, incremental }:
  Props)
{
  const id = useId();
  /** What was typed over the text that the table knows, until it is told. */
  const [held, hold] = useState<{ readonly over: string; readonly text: string } | null>(null);
  if (held && held.over !== told) hold(null);
  const text = held?.over === told ? held.text : told;
  const type = (next: string) => {
    if (next === text) return;
    if (!isLong) onText(next);
    else if (whileTyping(() => onText(next))) hold({ over: told, text: next });
  };
  const leave = () => {
    const sum = sumOf(text);
    if (sum !== null) type(sum);
    closeStep();
  };
  const onKey = (e: KeyboardEvent<HTMLInputElement>) => {
    if (incremental && e.key.toLowerCase() === "i" && !e.ctrlKey && !e.metaKey) {
      e.preventDefault();
      incremental.toggle();
      return;
    }
    if (onTangent && e.key.toLowerCase() === "t" && !e.ctrlKey && !e.metaKey) {
      e.preventDefault();
      onTangent();
      return;
    }
    if (e.key !== "-" || !isPlainNumber(text)) return;
    e.preventDefault();
    const input = e.currentTarget;
    const next = minus({ text, from: input.selectionStart ?? 0, to: input.selectionEnd ?? 0, negative: false });
    // At once: a caret that is placed later would fall between the keys of a fast hand.
    flushSync(() => type(next.text));
    input.setSelectionRange(next.from === next.to ? next.from : next.text.startsWith("-") ? 1 : 0, next.to);
  };
  return (
    <span className={`contour-cell field-${field}${shown?.solved ? " solved" : ""}`}>
      {incremental && (
        <button type="button" className="button plain contour-incremental number" aria-pressed={incremental.on}
          aria-label={incremental.name} title={incremental.name} tabIndex={-1} onClick={incremental.toggle}
        >
          I
        </button>
      )}
      <input id={id} className="input number" type="text" data-number="open" inputMode="text" autoComplete="off" spellCheck={false}
        maxLength={200} data-row={row} data-field={field} aria-label={name} aria-invalid={wrong}
        aria-describedby={shown === null ? describedBy : `${describedBy} ${id}-stays`} value={inScreenWriting(language, text)}
        placeholder={shown?.text ?? ""} onChange={(e) => type(e.currentTarget.value)} onBlur={leave}
        onFocus={(e) => e.currentTarget.select()} onKeyDown={onKey} {...(incremental ? { "aria-keyshortcuts": "I" } : {})} />
      {shown !== null && <span id={`${id}-stays`} className="unseen">{shown.name}</span>}
    </span>
  );
}
