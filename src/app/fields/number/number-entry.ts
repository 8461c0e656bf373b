/** The text of a prompt with its selection, as an input element holds it. */
export interface EntryState {
  readonly text: string;
  /** Selected characters: from, to; equal when it is only a caret. */
  readonly from: number;
  readonly to: number;
  /** The minus key was the first one on a value that was selected as a whole: a digit now begins a negative number. */
  readonly negative: boolean;
}

const plainNumber = /^\s*[+-]?\d*[.,]?\d*\s*$/;

/** True when minus means "change the sign" here; in a sum it is an ordinary minus. */
export const isPlainNumber = (text: string): boolean => plainNumber.test(text);

/** The whole number is selected, with or without its sign: what is typed next takes its place. */
const allSelected = ({ text, from, to }: EntryState) =>
  from < to && to === text.length && /^[+-]?$/.test(text.slice(0, from));

const caretAt = (text: string, at: number): EntryState => ({ text, from: at, to: at, negative: false });

/**
 * The same number with the other sign; the caret stays at its digit. Of a number that was selected as a whole the
 * digits stay selected, so that digits typed next take the place of its digits and keep the sign that is seen.
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
 * A digit behind a minus that changed the sign of the number before it: a sum is typed, as 60-2. `minuend` is what
 * stood there before the minus; null where the digit just goes on with the number.
 */
export const subtracted = ({ text, from }: EntryState, minuend: string, digit: string): EntryState | null =>
  text === `-${minuend}` && from === text.length
    ? caretAt(`${minuend}-${digit}`, minuend.length + 1 + digit.length)
    : null;

/** What a minus at its end may be taken from: digits that were typed, with the caret behind them. */
export const minuendOf = ({ text, from, to }: EntryState): string | null =>
  from === to && to === text.length && /^\d+[.,]?\d*$/.test(text) ? text : null;

/** One character, or several, in place of what is selected. */
export function insert(entry: EntryState, characters: string): EntryState {
  if (entry.negative && allSelected(entry)) return caretAt(`-${characters}`, characters.length + 1);
  const text = entry.text.slice(0, entry.from) + characters + entry.text.slice(entry.to);
  return caretAt(text, entry.from + characters.length);
}

/** The I in front of an incremental value: put there, or taken away. */
export const toggleIncremental = ({ text, from, to }: EntryState): EntryState =>
  /^I/i.test(text)
    ? { text: text.slice(1), from: 0, to: text.length - 1, negative: false }
    : { text: `I${text}`, from: from + 1, to: to + 1, negative: false };

/** Takes away what is selected, or the character before the caret. */
export function erase(entry: EntryState): EntryState {
  const from = entry.from === entry.to ? Math.max(0, entry.from - 1) : entry.from;
  return caretAt(entry.text.slice(0, from) + entry.text.slice(entry.to), from);
}
