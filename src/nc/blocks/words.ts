import { valueText } from "../number-text.ts";
import { feedText, unsigned } from "../print-words.ts";
import { axisName } from "../read-words.ts";
import type { Scan } from "../scan.ts";
import type { AxisName, FeedWord, FileName, Label, Parameter, Value } from "../words.ts";
import { readLabel, VALUE } from "../value.ts";
import type { ComparedWords } from "./compared-words.ts";
import type { Field, Spread, Unseen, Word } from "./define.ts";

/** Guide data of a word, besides its name. */
interface Guided {
  readonly spread?: Spread;
  readonly noPicture?: Unseen;
  readonly setup?: string;
}

/** A custom word. */
export const word = <const K extends string, T, const N extends string = never>(
  key: K,
  of: Omit<Word<K, T, N>, "key" | "lettered"> & { readonly lettered?: boolean },
): Word<K, T, N> => ({ lettered: false, ...of, key });

/** A property that its block kind reads and prints. `T`: its type. */
export const property =
  <T>() =>
  <const K extends string, const N extends string = never>(
    key: K,
    more: Pick<Word<K, T, N>, "compareAs" | "fields"> = {},
  ): Word<K, T, N> =>
    word(key, { take: () => undefined, text: () => "", ...more });

/** The field of a one-line text; `taken` parses it, undefined for invalid text. */
export const textField = <T, const N extends string>(
  name: N,
  shown: (value: T) => string,
  taken: (typed: string, before: T) => T | undefined,
  more: Omit<Partial<Field<T, N>>, "entry"> = {},
): Field<T, N> =>
  ({
    id: name,
    name,
    ...more,
    entry: "text",
    get: shown,
    put: (before: T, typed: string) => (/[\r\n]/.test(typed) ? undefined : taken(typed, before)),
  }) as Field<T, N>;

/** The field of a choice. */
export const choiceField = <T, const N extends string>(
  name: N,
  choices: readonly string[],
  shown: (value: T) => string,
  taken: (chosen: string, before: T) => T | undefined,
  guided: Guided = {},
): Field<T, N> =>
  ({
    id: name,
    name,
    choices,
    ...guided,
    entry: "choice",
    get: shown,
    put: (before: T, chosen: string) => taken(chosen, before),
  }) as Field<T, N>;

/** An optional number or parameter with its letters. */
export const value = <const K extends string, const N extends string = K>(
  key: K,
  letters: string,
  {
    plain = false,
    needed = false,
    field = true,
    colon,
    name = key as string as N,
    ...facts
  }: {
    /** Printed without a plus sign. */
    readonly plain?: boolean;
    /** True where its absence is reported. */
    readonly needed?: boolean;
    /** Whether forms ask for it. */
    readonly field?: boolean;
    /** A colon after the letters is accepted, or written. */
    readonly colon?: "read" | "written";
    readonly name?: N;
    readonly unit?: string;
  } & Guided = {},
): Word<K, Value | null, N> => {
  const pattern = new RegExp(String.raw`${letters}[ \t]*${colon ? ":?[ \\t]*" : ""}(${VALUE})`, "iy");
  const written = ` ${letters}${colon === "written" ? ":" : ""}`;
  const asked: Field<Value | null, N> = {
    id: name,
    name,
    letter: letters,
    ...facts,
    entry: "value",
    get: (v) => v,
    put: (_, v) => v,
  };
  return word(key, {
    lettered: true,
    absent: null,
    ...(needed && { needed: letters }),
    take: (scan) => {
      const m = scan.take(pattern);
      return m ? scan.value(m[1] ?? "") : undefined;
    },
    text: (v, style) => (v === null ? "" : written + (plain ? unsigned(v, style) : valueText(v, style))),
    compareAs: (v, said) => void said.number(letters, v),
    fields: () => (field ? [asked] : []),
  });
};

/**
 * A length given in one of two measures, such as D and R; the first is the default. mm. `measure`: the field of the
 * measure.
 */
export const measured = <const K extends string, const N extends string, const M extends string>(
  key: K,
  measure: N,
  measures: readonly [M, M],
  { needed = false, ...guided }: { readonly needed?: boolean } & Guided = {},
): Word<K, { readonly measure: M; readonly value: Value } | null, K | N> => {
  type Measured = { readonly measure: M; readonly value: Value } | null;
  const pattern = new RegExp(String.raw`(${measures.join("|")})[ \t]*(${VALUE})`, "iy");
  const [usual] = measures;
  // The first letter of the measure: DI is D.
  const letterOf = (of: M) => of.slice(0, 1);
  return word<K, Measured, K | N>(key, {
    lettered: true,
    absent: null,
    ...(needed && { needed: usual }),
    take: (scan) => {
      const m = scan.take(pattern);
      const read = m && scan.value(m[2] ?? "");
      if (!m) return undefined;
      const written = measures.find((each) => each === m[1]?.toUpperCase()) ?? usual;
      return read === null ? null : { measure: written, value: read };
    },
    text: (v, style) => (v === null ? "" : ` ${v.measure}${unsigned(v.value, style)}`),
    compareAs: (v, said) => void said.number(v?.measure ?? usual, v?.value),
    fields: () => [
      {
        id: key,
        name: key,
        letter: usual,
        unit: "mm",
        ...guided,
        entry: "value",
        get: (v) => v?.value ?? null,
        put: (v, next) => (next === null ? null : { measure: v?.measure ?? usual, value: next }),
      },
      choiceField<Measured, N>(
        measure,
        measures.map(letterOf),
        (v) => letterOf(v?.measure ?? usual),
        (chosen, v) => v && { ...v, measure: measures.find((each) => letterOf(each) === chosen) ?? usual },
      ),
    ],
  });
};

/** One of several words. `lead`: text in front of it without a blank. */
export const choice = <const K extends string, const C extends string, const N extends string = K>(
  key: K,
  choices: readonly C[],
  {
    lead = "",
    otherwise,
    compared = false,
    name = key as string as N,
    ...guided
  }: {
    readonly lead?: string;
    /** The value where none of them is written. */
    readonly otherwise?: C;
    readonly compared?: boolean;
    readonly name?: N;
  } & Guided = {},
): Word<K, C, N> => {
  const pattern = new RegExp(String.raw`${lead}(${choices.join("|")})(?![A-Z])`, "iy");
  const of = (text: string) => choices.find((each) => each === text.toUpperCase());
  return word(key, {
    ...(otherwise !== undefined && { absent: otherwise }),
    ...(compared && { compareAs: (c: C, said: ComparedWords) => void said.put("", c) }),
    take: (scan) => {
      const m = scan.take(pattern);
      return m ? of(m[1] ?? "") : undefined;
    },
    text: (c) => ` ${lead}${c}`,
    fields: () => [choiceField<C, N>(name, choices, (c) => c, of, guided)],
  });
};

const AXIS = /([XYZABCUVW])(?![A-Z])/iy;
const isAxis = (letter: string): letter is AxisName => /^[XYZABCUVW]$/.test(letter);

/** The spindle axis, without which the block cannot be read. */
export const toolAxis = <const K extends string>(
  key: K,
  { compared = true }: { readonly compared?: boolean } = {},
): Word<K, AxisName, "toolAxis"> =>
  word(key, {
    ...(compared && { compareAs: (axis: AxisName, said: ComparedWords) => void said.put("", axis) }),
    take: (scan) => {
      const m = scan.take(AXIS);
      return m ? axisName(m[1] ?? "") : undefined;
    },
    text: (axis) => ` ${axis}`,
    fields: () => [axisField(["X", "Y", "Z"])],
  });

/** The optional spindle axis. */
export const optionalToolAxis = <const K extends string>(
  key: K,
  pattern = AXIS,
  choices: readonly string[] = ["", "X", "Y", "Z"],
): Word<K, AxisName | null, "toolAxis"> =>
  word(key, {
    absent: null,
    take: (scan) => {
      const m = scan.take(pattern);
      return m ? axisName(m[1] ?? "") : undefined;
    },
    text: (axis) => (axis === null ? "" : ` ${axis}`),
    compareAs: (axis, said) => void said.put("", axis),
    fields: () => [
      choiceField<AxisName | null, "toolAxis">(
        "toolAxis",
        choices,
        (axis) => axis ?? "",
        (chosen) => (isAxis(chosen) ? chosen : null),
        { noPicture: "choice" },
      ),
    ],
  });
const axisField = (choices: readonly string[]): Field<AxisName, "toolAxis"> =>
  choiceField<AxisName, "toolAxis">(
    "toolAxis",
    choices,
    (axis) => axis,
    (chosen) => (isAxis(chosen) ? chosen : undefined),
    { noPicture: "choice" },
  );

/** A label by its number, its name in quotes, or the QS parameter that holds it. */
export const labelText = (label: Label): string =>
  typeof label === "number" ? String(label) : /^QS\d/i.test(label) ? label : `"${label}"`;
/** A label as typed. */
export const shownLabel = (label: Label | Parameter): string =>
  typeof label === "object" ? label.parameter : String(label);
/** A typed label: digits are its number, anything else its name. */
export const typedLabel = (typed: string): Label | undefined => {
  const text = typed.trim().replaceAll('"', "");
  if (text === "" || /[\r\n]/.test(text)) return undefined;
  return /^\d{1,9}$/.test(text) ? Number(text) : text;
};
export const labelField = <T extends Label | Parameter>(): Field<T, "label"> =>
  textField<T, "label">("label", shownLabel, (typed) => typedLabel(typed) as T | undefined, {
    letter: "LBL",
    noPicture: "name",
  });

const TOOL = /(?:(\d{1,9}(?:[.,]\d)?)(?![\d.,])|"([^"]*)")/y;
/** A tool by number, with or without an index, or by name; null where absent. */
export function takeTool(scan: Scan): Label | null {
  const m = scan.take(TOOL);
  return m && readLabel(m[1]?.replace(",", "."), m[2]);
}

const QUOTED = /"([^"]*)"/y;
/** The quoted text here; null where absent. */
export const takeQuoted = (scan: Scan): string | null => scan.take(QUOTED)?.[1] ?? null;

/** Everything up to the end of the line. */
export function takeRest(scan: Scan): string {
  const { rest } = scan;
  scan.at = scan.text.length;
  return rest;
}

export const fileText = (file: FileName, isBare = false): string =>
  typeof file === "object" ? file.parameter : isBare ? file : `"${file}"`;

const NAMED_FEED = new RegExp(String.raw`(?:F[ \t]*(MAX|AUTO)(?![A-Z])|(F[UZ]?)[ \t]*(${VALUE}))`, "iy");

/** The field of a feed. */
export const plainFeedField: Field<FeedWord | null, "feed"> = {
  id: "feed",
  name: "feed",
  letter: "F",
  spread: { times: [0.5, 2] },
  entry: "feed",
  get: (feed) => feed,
  put: (_, feed) => feed,
};

/** An optional feed: FMAX, FAUTO, or a value with its unit. */
export const feed = <const K extends string>(key: K): Word<K, FeedWord | null, "feed"> =>
  word(key, {
    lettered: true,
    absent: null,
    take: (scan) => {
      const m = scan.take(NAMED_FEED);
      if (!m) return undefined;
      if (m[1] !== undefined) return m[1].toUpperCase() === "MAX" ? "max" : "auto";
      const read = scan.value(m[3] ?? "");
      return read === null ? null : { value: read, unit: (m[2] ?? "F").toUpperCase() as "F" | "FU" | "FZ" };
    },
    text: (v, style) => (v === null ? "" : ` ${feedText(v, style)}`),
    compareAs: (v, said) => void (v && said.feed("F", v)),
    fields: () => [plainFeedField],
  });

/** Words that are not understood but stored. */
export const extra = <const K extends string>(key: K): Word<K, readonly string[], never> =>
  word<K, readonly string[], never>(key, {
    take: () => undefined,
    absent: [],
    keep: (words, next) => [...words, next],
    text: (words) => words.map((each) => ` ${each}`).join(""),
    compareAs: (words, said) => void (words.length > 0 && said.text("", words.join(" "))),
  });
