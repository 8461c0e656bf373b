import { tokensOf, type Token } from "./tokens.ts";

/** A word with its value, `X+50`, or anything else between blanks; the text is compared however it is spelled. */
interface Unit {
  readonly from: number;
  readonly to: number;
  readonly meaning: string;
}

const NUMBER = /[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)/g;
/** A word as every spelling of it: `x +50.000` and `X+50` are one. */
const meaningOf = (text: string): string =>
  text.startsWith('"')
    ? text
    : text
        .toUpperCase()
        .replaceAll(/[ \t\u00a0]/g, "")
        .replaceAll(NUMBER, (number) => String(Number(number.replace(",", "."))))
        .replaceAll(/\+(?=Q)/g, "");

const isOpen = ({ kind }: Token): boolean => kind === "word" || kind === "mark";
const isValue = ({ kind }: Token): boolean => kind === "value" || kind === "parameter" || kind === "mark";

function unitsOf(line: string): readonly Unit[] {
  const spans: { from: number; to: number; last: Token }[] = [];
  for (const token of tokensOf(line)) {
    const open = spans.at(-1);
    const joins =
      open !== undefined &&
      ((isOpen(open.last) && isValue(token)) || (open.last.kind === "mark" && open.last.to === token.from));
    if (joins) Object.assign(open, { to: token.to, last: token });
    else spans.push({ from: token.from, to: token.to, last: token });
  }
  return spans.map(({ from, to }) => ({ from, to, meaning: meaningOf(line.slice(from, to)) }));
}

/**
 * A line of text in which only those words change that differ between two printed lines; all others stay as they are
 * written. `written` has the meaning of `before`. Null if a word is not found, or if the first one differs: another
 * form of block is printed as a whole.
 */
export function withChangedWords(written: string, before: string, after: string): string | null {
  const [all, old, wanted] = [unitsOf(written), unitsOf(before), unitsOf(after)];
  let front = 0;
  while (front < Math.min(old.length, wanted.length) && old[front]?.meaning === wanted[front]?.meaning) front += 1;
  if (front === 0) return null;
  let behind = 0;
  while (
    behind < Math.min(old.length, wanted.length) - front &&
    old.at(-1 - behind)?.meaning === wanted.at(-1 - behind)?.meaning
  )
    behind += 1;
  /** The same word of the written line. */
  const unitAt = (index: number): Unit | undefined => all.find((each) => each.meaning === old[index]?.meaning);
  const [first, last] = [wanted[front], wanted[wanted.length - 1 - behind]];
  const added = first && last && front < wanted.length - behind ? after.slice(first.from, last.to) : "";
  const removed: Unit[] = [];
  for (let i = front; i < old.length - behind; i += 1) {
    const unit = unitAt(i);
    if (!unit) return null;
    removed.push(unit);
  }
  const [place] = removed;
  const anchor = place ?? unitAt(front - 1);
  if (!anchor) return null;
  const cuts = removed.map((unit) => ({
    from: unit === place && added !== "" ? unit.from : written.slice(0, unit.from).trimEnd().length,
    to: unit.to,
    text: unit === place ? added : "",
  }));
  if (!place && added !== "") cuts.push({ from: anchor.to, to: anchor.to, text: ` ${added}` });
  return cuts
    .toSorted((a, b) => b.from - a.from)
    .reduce((text, { from, to, text: put }) => text.slice(0, from) + put + text.slice(to), written);
}
