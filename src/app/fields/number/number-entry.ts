/** The text of a prompt with its selection, as an input element holds it. */
export interface EntryState {
  readonly text: string;
  /** Selected characters: from, to; equal when it is only a caret. */
  readonly from: number;
  readonly to: number;
  /** The minus key came first on a fully selected value: the next digit begins a negative number. */
  readonly negative: boolean;
}

const plainNumber = /^[+-]?\d*(?:[.,]\d*)?$/;

/** True when minus means "change the sign" here; in a sum it is an ordinary minus. */
export const isPlainNumber = (text: string): boolean => plainNumber.test(text.trim());

/** A sign without a digit: a number that has only begun, not a wrong one yet. */
export const isOnlySign = (text: string): boolean => /^\s*I?[+-]\s*$/i.test(text);

/** The whole number is selected, with or without its sign: the next input replaces it. */
const allSelected = ({ text, from, to }: EntryState) =>
  from < to && to === text.length && /^[+-]?$/.test(text.slice(0, from));

const caretAt = (text: string, at: number): EntryState => ({ text, from: at, to: at, negative: false });

/**
 * Toggles the sign; the caret stays at its digit. If the whole number was selected, its digits stay selected, so that
 * new digits replace them and keep the new sign.
 */
export function toggleSign(entry: EntryState): EntryState {
  const { text, from, to } = entry;
  const old = /^\s*[+-]?/.exec(text)?.[0] ?? "";
  const sign = old.includes("-") ? "" : "-";
  const next = sign + text.slice(old.length);
  if (allSelected(entry)) return { text: next, from: sign.length, to: next.length, negative: false };
  const shift = (at: number) => Math.max(sign.length, at + sign.length - old.length);
  return { text: next, from: shift(from), to: shift(to), negative: false };
}

/** The minus key: changes the sign of a number, is a minus in a sum. */
export function minus(entry: EntryState): EntryState {
  if (!isPlainNumber(entry.text)) return insert(entry, "-");
  return { ...toggleSign(entry), negative: allSelected(entry) };
}

/**
 * A digit after a minus that changed the sign: a subtraction is typed, as 60-2 or -55-2. `minuend` is the text before
 * the minus. Null if the digit just continues the number.
 */
export const subtracted = ({ text, from }: EntryState, minuend: string, digit: string): EntryState | null =>
  text === toggleSign(caretAt(minuend, minuend.length)).text && from === text.length
    ? caretAt(`${minuend}-${digit}`, minuend.length + 1 + digit.length)
    : null;

/** The minuend for a minus at the end: typed digits with the caret behind them; else null. */
export const minuendOf = ({ text, from, to }: EntryState): string | null =>
  from === to && to === text.length && /^[+-]?\d+(?:[.,]\d*)?$/.test(text) ? text : null;

/** Replaces the selection by one or more characters. */
export function insert(entry: EntryState, characters: string): EntryState {
  if (entry.negative && allSelected(entry)) return caretAt(`-${characters}`, characters.length + 1);
  const text = entry.text.slice(0, entry.from) + characters + entry.text.slice(entry.to);
  return caretAt(text, entry.from + characters.length);
}

/** Toggles the I of an incremental value. */
export const toggleIncremental = ({ text, from, to }: EntryState): EntryState =>
  /^I/i.test(text)
    ? { text: text.slice(1), from: 0, to: text.length - 1, negative: false }
    : { text: `I${text}`, from: from + 1, to: to + 1, negative: false };

/** Deletes the selection, or the character before the caret. */
export function erase(entry: EntryState): EntryState {
  const from = entry.from === entry.to ? Math.max(0, entry.from - 1) : entry.from;
  return caretAt(entry.text.slice(0, from) + entry.text.slice(entry.to), from);
}
