import { unsigned } from "../print-words.ts";
import type { Scan } from "../scan.ts";
import type { NamedWord, Value } from "../words.ts";
import type { Style } from "../style.ts";
import { VALUE } from "../value.ts";
import type { FieldFacts, Spread, ValueField, Word } from "./define.ts";
import { word } from "./words.ts";

const NAMED = new RegExp(String.raw`([A-Z_]+?)[ \t]*:?[ \t]*(${VALUE})`, "iy");
/** Words that are angles, degrees; the others are lengths, mm. */
const ANGLES: ReadonlySet<string> = new Set(["ANGLE", "ANG_WIDTH", "FACEANGLE", "ROT"]);
const HALF_AND_DOUBLE: Spread = { times: [0.5, 2] };

/** Guide values of a word, for any block. */
const SPREADS: Readonly<Record<string, Spread>> = {
  DZL: { plus: [-0.5, 0.5] },
  DXL: { plus: [-0.5, 0.5] },
  DEPTH: { times: [0.5, 1.4] },
  DIAM: { plus: [-1, 2] },
  BREADTH: { times: [0.7, 1.5] },
  R: HALF_AND_DOUBLE,
  ANGLE: { plus: [-4, 15] },
  FACEDEPTH: HALF_AND_DOUBLE,
  FACEANGLE: { plus: [-3, 5] },
  ROT: { plus: [-15, 15] },
  PITCH: HALF_AND_DOUBLE,
  CENTER: { plus: [-5, 5] },
  CHF: HALF_AND_DOUBLE,
  RND: HALF_AND_DOUBLE,
  FAR_RND: HALF_AND_DOUBLE,
  FAR_CHF: HALF_AND_DOUBLE,
};

type Words = readonly NamedWord[];

/** Words of the form NAME and value, with or without a colon between them. */
function takeNamed(scan: Scan): Words {
  const words: NamedWord[] = [];
  for (let m = scan.take(NAMED); m; m = scan.take(NAMED)) {
    const value = scan.value(m[2] ?? "");
    if (value !== null) words.push({ name: (m[1] ?? "").toUpperCase(), value });
  }
  return words;
}

/** The field of one word in a list; a new word is placed by `order`. */
export const namedField = (
  name: string,
  order: readonly string[] | null,
  more: Partial<FieldFacts<never>> = {},
): ValueField<Words, "value", never> => {
  const find = (words: Words) => words.find((w) => w.name === name);
  const put = (words: Words, value: Value | null): Words => {
    if (value === null) return words.filter((w) => w.name !== name);
    if (find(words)) return words.map((w) => (w.name === name ? { name, value } : w));
    const next = [...words, { name, value }];
    return order ? next.sort((a, b) => order.indexOf(a.name) - order.indexOf(b.name)) : next;
  };
  return {
    id: `word ${name}`,
    name: { word: name },
    unit: ANGLES.has(name) ? "°" : "mm",
    ...more,
    entry: "value",
    get: (words) => find(words)?.value ?? null,
    put,
  };
};

/** Named words: the usual ones of the statement, and any other word of the block. */
export const namedWords = (
  usual: (statement: never) => readonly string[],
  {
    colon = false,
    spreads = {},
  }: { readonly colon?: boolean; readonly spreads?: Readonly<Record<string, Spread>> } = {},
): Word<"words", Words, never> =>
  word<"words", Words, never>("words", {
    take: takeNamed,
    text: (words: Words, style: Style) =>
      words.map((w) => ` ${w.name}${colon ? ":" : ""}${unsigned(w.value, style)}`).join(""),
    compareAs: (words, said) => void said.named(words),
    fields: (words, statement) => {
      const own = usual(statement);
      const order = [...own, ...words.map((w) => w.name).filter((name) => !own.includes(name))];
      return order.map((name) => {
        const spread = spreads[name] ?? SPREADS[name];
        return namedField(name, order, spread && { spread });
      });
    },
  });
