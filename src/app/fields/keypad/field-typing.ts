import { flushSync } from "react-dom";
import type { EntryState } from "../number/number-entry.ts";

/**
 * Which letters a number field takes beside digits: "words" parameters, "open" also a question mark for what is not
 * given.
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

/**
 * What of the page a field belongs to: the open dialog, or all of it. A keypad outside a modal dialog could not be
 * pressed.
 */
export const scopeOf = (field: HTMLElement): HTMLElement => field.closest<HTMLElement>("dialog") ?? document.body;

/** The text of a field with its selection. */
export const fieldEntry = (field: HTMLInputElement): EntryState => ({
  text: field.value,
  from: field.selectionStart ?? field.value.length,
  to: field.selectionEnd ?? field.value.length,
  negative: false,
});

/** Writes into a field as if it were typed: whoever listens to it hears the same. */
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

/** The keyboard goes to the next or previous number field; false at either end. */
export function stepField(field: HTMLInputElement, by: 1 | -1): boolean {
  const fields = numberFields(scopeOf(field)),
    next = fields[fields.indexOf(field) + by];
  next?.focus();
  next?.select();
  return next !== undefined;
}

/** ENT: what the field itself does with Enter, or else the next field; behind the last one the keypad goes away. */
export function enterField(field: HTMLInputElement): void {
  const event = new KeyboardEvent("keydown", { key: "Enter", bubbles: true, cancelable: true });
  flushSync(() => field.dispatchEvent(event));
  if (!event.defaultPrevented && !stepField(field, 1)) field.blur();
}
