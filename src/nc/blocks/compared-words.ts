import { valueText } from "../number-text.ts";
import { feedText } from "../print-words.ts";
import type { AxisWord, FeedWord, Label, NamedWord, Parameter, PolarWord, Value } from "../words.ts";
import { LAYOUTS, type Style } from "../style.ts";

/** The uniform spelling for comparisons. */
export const BARE: Style = { ...LAYOUTS.tnc7, plus: false };
const SIGNED: Style = { ...BARE, plus: true };

const QUOTED = /("[^"]*")/;
const NUMBER =
  /(?<![\w.,])(?:([+-])[ \t]*|(?<![\w.,\s])[ \t]+)?(\d+(?:[.,]\d*)?|[.,]\d+)(?![\w.,])|(?<=[A-Z])([+-]?)(\d+[.,]\d*|[.,]\d+)(?![\w.,])/gi;
const plainNumber = (sign: string, digits: string): string => {
  const size = Number(digits.replace(",", "."));
  return `${sign === "-" && size !== 0 ? "-" : ""}${size}`;
};

/** Text in uniform spelling: case, blanks and number formats count only inside quotes. */
export function plainText(raw: string): string {
  return raw
    .split(QUOTED)
    .map((part, i) =>
      i % 2 === 1
        ? part
        : part
            .toUpperCase()
            .replace(
              NUMBER,
              (
                _,
                sign: string | undefined,
                digits: string | undefined,
                behind: string | undefined,
                more: string | undefined,
              ) => plainNumber(sign ?? behind ?? "", digits ?? more ?? "0"),
            )
            .replace(/\s+/g, " ")
            .replace(/ ?([=*/()]) ?/g, "$1"),
    )
    .join("")
    .trim();
}

/** A label in uniform spelling. */
export const plainLabel = (label: Label | Parameter): string =>
  typeof label === "object" ? valueText(label, BARE) : typeof label === "string" ? `"${label}"` : String(label);

/** Words of a block by name, in uniform spelling; a repeated word is joined into one with both values. */
export class ComparedWords {
  readonly words = new Map<string, string>();

  put(name: string, value: string | null | undefined): this {
    if (value === null || value === undefined) return this;
    const before = this.words.get(name);
    this.words.set(name, before === undefined ? value : `${before} ${value}`);
    return this;
  }

  number(name: string, value: Value | null | undefined): this {
    return this.put(name, value === null || value === undefined ? null : valueText(value, BARE));
  }

  signed(name: string, value: Value): this {
    return this.put(name, valueText(value, SIGNED));
  }

  /** A feed without its F. */
  feed(name: string, feed: FeedWord): this {
    return this.put(name, feedText(feed, BARE).replace(/^F(?=[\d.-])/, ""));
  }

  text(name: string, raw: string): this {
    return this.put(name, plainText(raw));
  }

  label(name: string, label: Label | Parameter): this {
    return this.put(name, plainLabel(label));
  }

  axes(axes: readonly AxisWord[], lead = ""): this {
    for (const { axis, value, incremental } of axes) this.signed(`${lead}${incremental ? "I" : ""}${axis}`, value);
    return this;
  }

  polar(name: string, word: PolarWord | undefined): this {
    return word ? this.signed(`${word.incremental ? "I" : ""}${name}`, word.value) : this;
  }

  named(words: readonly NamedWord[]): this {
    for (const { name, value } of words) this.number(name, value);
    return this;
  }
}
