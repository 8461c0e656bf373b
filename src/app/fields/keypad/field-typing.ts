import { flushSync } from "react-dom";
import type { EntryState } from "../number/number-entry.ts";

/**
 * Letters a number field accepts besides digits: "words" for parameters, "open" also a question mark for an unknown
 * value.
 */
export type NumberLetters = "words" | "open";

/** The number fields of a page or of a dialog over it, as the keyboard visits them. */
const numberFields = (root: ParentNode): readonly HTMLInputElement[] =>
  [...root.querySelectorAll<HTMLInputElement>("input[data-number]")].filter(
    (each) => !each.disabled && (each.checkVisibility?.() ?? true),
  );

/** The number field that an element is; null for anything else. */
export const numberFieldOf = (target: EventTarget | null): HTMLInputElement | null =>
  target instanceof HTMLInputElement && target.dataset["number"] !== undefined ? target : null;

/** Container of a field: its dialog, or the page. A keypad outside a modal dialog could not be clicked. */
export const scopeOf = (field: HTMLElement): HTMLElement => field.closest<HTMLElement>("dialog") ?? document.body;

/** The text of a field with its selection. */
export const fieldEntry = (field: HTMLInputElement): EntryState => ({
  text: field.value,
  from: field.selectionStart ?? field.value.length,
  to: field.selectionEnd ?? field.value.length,
  negative: false,
});

/** Writes into a field with the same events as typing. */
export function writeEntry(field: HTMLInputElement, { text, from, to }: EntryState): void {
  if (text !== field.value) {
    const set = Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set;
    flushSync(() => {
      set?.call(field, text);
      field.dispatchEvent(new Event("input", { bubbles: true }));
    });
  }
  field.setSelectionRange(from, to);
}

/** Focuses the next or previous number field; false at either end. */
export function stepField(field: HTMLInputElement, by: 1 | -1): boolean {
  const fields = numberFields(scopeOf(field)),
    next = fields[fields.indexOf(field) + by];
  next?.focus();
  next?.select();
  return next !== undefined;
}

/** ENT: the field's own Enter action, or else the next field; after the last one the keypad closes. */
export function enterField(field: HTMLInputElement): void {
  const event = new KeyboardEvent("keydown", { key: "Enter", bubbles: true, cancelable: true });
  flushSync(() => field.dispatchEvent(event));
  if (!event.defaultPrevented && !stepField(field, 1)) field.blur();
}
