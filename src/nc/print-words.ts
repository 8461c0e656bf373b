import { valueText } from "./number-text.ts";
import type { AxisWord, CycleParameter, FeedWord, PolarWord, Value, Words } from "./words.ts";
import type { Style } from "./style.ts";

/** Values that carry no plus sign: radii of roundings, lengths of chamfers, feeds. */
export const unsigned = (value: Value, style: Style) => valueText(value, { ...style, plus: false });

const axisText = (w: AxisWord, style: Style) => `${w.incremental ? "I" : ""}${w.axis}${valueText(w.value, style)}`;
const polarText = (name: string, w: PolarWord | undefined, style: Style) =>
  w ? [`${w.incremental ? "I" : ""}${name}${valueText(w.value, style)}`] : [];

/** A feed word: FMAX, FAUTO, F300. */
export const feedText = (feed: FeedWord, style: Style) =>
  feed === "max" ? style.rapid : feed === "auto" ? "FAUTO" : `${feed.unit}${unsigned(feed.value, style)}`;

/** Which numbers of an approach or arc carry a sign; `length` and `radius` differ from form to form. */
export interface Signs {
  readonly length: boolean;
  readonly radius: boolean;
}

/**
 * The words of a path block in the control's order, each with its leading blanks. The TNC 640 writes two blanks before
 * the third axis and before M, as its printed positioning blocks show.
 */
export function wordsText(words: Words, style: Style, signs: Signs = { length: true, radius: true }): string {
  const parts: string[] = [];
  const add = (text: string, blanks = 1) => parts.push(" ".repeat(style.wide ? blanks : 1) + text);
  words.axes.forEach((w, i) => add(axisText(w, style), i === 2 || i === 0 ? 2 : 1));
  for (const text of [...polarText("PR", words.polarRadius, style), ...polarText("PA", words.polarAngle, style)])
    add(text, parts.length === 0 ? 2 : 1);
  const gap = style.spacedWords ? " " : "";
  const spaced = (name: string, value: string) => add(`${name}${/^[+-]/.test(value) ? "" : gap}${value}`);
  if (words.centreAngle !== undefined) spaced("CCA", unsigned(words.centreAngle, style));
  if (words.length !== undefined)
    spaced("LEN", signs.length ? valueText(words.length, style) : unsigned(words.length, style));
  // A bare R0 would be read as the end of the compensation.
  const radius = (r: Value) =>
    r === 0 ? valueText(r, { ...style, plus: true }) : signs.radius ? valueText(r, style) : unsigned(r, style);
  if (words.radius !== undefined) add(`R${radius(words.radius)}`, parts.length === 0 ? 2 : 1);
  if (words.turn !== undefined) add(words.turn === "ccw" ? "DR+" : "DR-");
  for (const w of words.linear ?? []) add(`LIN_${axisText(w, style)}`);
  if (words.compensation !== undefined) add(words.compensation);
  if (words.feed !== undefined) add(feedText(words.feed, style));
  for (const m of words.functions) add(`M${unsigned(m, style)}`, parts.length === 0 ? 1 : 2);
  if (words.retract !== undefined) add(`MB${words.retract === "max" ? " MAX" : valueText(words.retract, style)}`);
  if (words.functionFeed !== undefined) add(feedText(words.functionFeed, style));
  for (const word of words.extra ?? []) add(word);
  return parts.join("");
}

/** The text of a cycle value; empty for an unset one. */
export function parameterValueText(value: CycleParameter["value"], style: Style): string {
  if (value === null) return "";
  if (value === "auto") return "FAUTO";
  return value === "max" ? "FMAX" : valueText(value, style);
}
