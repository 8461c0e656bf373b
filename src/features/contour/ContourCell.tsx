import { useId, useState, type KeyboardEvent } from "react";
import type { RowField } from "../../program/job/contour-rows.ts";
import { NumberInput } from "../../app/fields/number/NumberInput.tsx";
import { closeStep } from "../../app/document/steps.ts";
import { whileTyping } from "../../app/base/typing.ts";
import { beginsTolerance, noteLeft, noteTyped } from "./begun-field.ts";

/** Placeholder of an empty field: the modal coordinate, or the solved value. */
export interface Shown {
  readonly text: string;
  readonly name: string;
  readonly solved: boolean;
}

interface Props {
  readonly row: string;
  readonly field: RowField;
  readonly name: string;
  readonly text: string;
  readonly shown: Shown | null;
  readonly wrong: boolean;
  readonly describedBy: string;
  /** In a long table, drawing and table get a digit after it is painted. */
  readonly isLong: boolean;
  readonly onText: (text: string) => void;
  /** The T key: tangential to the previous element. */
  readonly onTangent?: () => void;
  /** The I key of the coordinate; absent where a value cannot be incremental. */
  readonly incremental?: { readonly on: boolean; readonly name: string; readonly toggle: () => void };
}

/** One number of the contour table, with its I key where it is a coordinate. */
export function ContourCell({
  row,
  field,
  name,
  text: told,
  shown,
  wrong,
  describedBy,
  isLong,
  onText,
  onTangent,
  incremental,
}: Props) {
  const id = useId();
  /** The typed text that the table does not have yet. */
  const [held, hold] = useState<{ readonly over: string; readonly text: string } | null>(null);
  if (held && held.over !== told) hold(null);
  const text = held?.over === told ? held.text : told;
  const type = (next: string) => {
    if (next === text) return;
    noteTyped(row, field, next);
    if (!isLong) onText(next);
    else if (whileTyping(() => onText(next))) hold({ over: told, text: next });
  };
  const onKey = (e: KeyboardEvent) => {
    const act = { i: incremental?.toggle, t: onTangent }[e.key.toLowerCase()];
    if (!act || e.ctrlKey || e.metaKey || beginsTolerance(text)) return;
    e.preventDefault();
    act();
  };
  return (
    <span className={`contour-cell field-${field}${shown?.solved ? " solved" : ""}`}>
      {incremental && (
        <button
          type="button"
          className="button plain contour-incremental number"
          aria-pressed={incremental.on}
          aria-label={incremental.name}
          title={incremental.name}
          tabIndex={-1}
          onClick={incremental.toggle}
        >
          I
        </button>
      )}
      <NumberInput
        keypad="open"
        inputMode="text"
        data-row={row}
        data-field={field}
        aria-label={name}
        aria-invalid={wrong}
        aria-describedby={shown === null ? describedBy : `${describedBy} ${id}-stays`}
        text={text}
        onText={type}
        onLeave={() => {
          noteLeft();
          closeStep();
        }}
        selects
        placeholder={shown?.text ?? ""}
        onKeyDown={onKey}
        {...(incremental && { "aria-keyshortcuts": "I" })}
      />
      {shown !== null && (
        <span id={`${id}-stays`} className="unseen">
          {shown.name}
        </span>
      )}
    </span>
  );
}
