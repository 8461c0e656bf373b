import { ANGLE_WORDS } from "../../../kernel/contour/undercut.ts";
import type { AxisName, AxisWord, NamedWord, PolarWord, Statement, Value, Words } from "../../../nc/statement.ts";
import { typedFunctions } from "../../../program/edits/approach-draft.ts";
import { blockValue, feedAsTyped, noWords, typedFeed, valueAsTyped } from "../../../program/values/typed-value.ts";
import { optionalValue, type WordField, type FieldName } from "./field.ts";

type WithWords = Extract<Statement, { words: Words }>;
const hasWords = (s: Statement): s is WithWords => "words" in s && "functions" in s.words;
const wordsOf = (s: Statement): Words => (hasWords(s) ? s.words : noWords);
const withWords = (s: Statement, words: Words): Statement => (hasWords(s) ? ({ ...s, words } as Statement) : s);

/** Sets one of the words, or takes it out. */
function put<K extends keyof Words>(s: Statement, key: K, value: Words[K] | null): Statement {
  const { [key]: _, ...rest } = wordsOf(s);
  return withWords(s, (value === null || value === undefined ? rest : { ...rest, [key]: value }) as Words);
}

const ORDER: readonly AxisName[] = ["X", "Y", "Z", "A", "B", "C", "U", "V", "W"];
const NAMES: Partial<Record<AxisName, FieldName>> = { X: "x", Y: "y", Z: "z" };
const rank = (w: AxisWord) => ORDER.indexOf(w.axis);

/** A coordinate with its switch for incremental. */
export const axisField = (axis: AxisName): WordField => {
  const find = (s: Statement) => wordsOf(s).axes.find((w) => w.axis === axis);
  const set = (s: Statement, word: AxisWord | null): Statement => {
    const { axes } = wordsOf(s);
    const others = axes.filter((w) => w.axis !== axis);
    if (!word) return withWords(s, { ...wordsOf(s), axes: others });
    const next = axes.some((w) => w.axis === axis)
      ? axes.map((w) => (w.axis === axis ? word : w))
      : [...axes, word].sort((a, b) => rank(a) - rank(b));
    return withWords(s, { ...wordsOf(s), axes: next });
  };
  return {
    id: axis,
    name: NAMES[axis] ?? { word: axis },
    numeric: true,
    unit: "mm",
    read: (s) => valueAsTyped(find(s)?.value),
    write: (s, typed) =>
      optionalValue(typed, (value) =>
        set(s, value === null ? null : { axis, value, incremental: find(s)?.incremental ?? false }),
      ),
    incremental: {
      read: (s) => find(s)?.incremental ?? false,
      write: (s, on) => {
        const word = find(s);
        return word ? set(s, { ...word, incremental: on }) : s;
      },
    },
  };
};

/** A word that carries a value: R, CCA, LEN. */
export const valueWord = (key: "radius" | "centreAngle" | "length", name: FieldName, unit = "mm"): WordField => ({
  id: key,
  name,
  numeric: true,
  unit,
  read: (s) => valueAsTyped(wordsOf(s)[key]),
  write: (s, typed) => optionalValue(typed, (value) => put(s, key, value)),
});

/** PR or PA with its switch for incremental. */
export const polarWord = (key: "polarRadius" | "polarAngle", name: FieldName, unit: string): WordField => {
  const find = (s: Statement): PolarWord | undefined => wordsOf(s)[key];
  return {
    id: key,
    name,
    numeric: true,
    unit,
    read: (s) => valueAsTyped(find(s)?.value),
    write: (s, typed) =>
      optionalValue(typed, (value) =>
        put(s, key, value === null ? null : { value, incremental: find(s)?.incremental ?? false }),
      ),
    incremental: {
      read: (s) => find(s)?.incremental ?? false,
      write: (s, on) => {
        const word = find(s);
        return word ? put(s, key, { ...word, incremental: on }) : s;
      },
    },
  };
};

export const turnField: WordField = {
  id: "turn",
  name: "turn",
  choices: ["", "cw", "ccw"],
  read: (s) => wordsOf(s).turn ?? "",
  write: (s, typed) => put(s, "turn", typed === "cw" || typed === "ccw" ? typed : null),
};

export const compensationField: WordField = {
  id: "compensation",
  name: "compensation",
  choices: ["", "R0", "RL", "RR"],
  read: (s) => wordsOf(s).compensation ?? "",
  write: (s, typed) => put(s, "compensation", typed === "R0" || typed === "RL" || typed === "RR" ? typed : null),
};

export const feedField: WordField = {
  id: "feed",
  name: "feed",
  read: (s) => feedAsTyped(wordsOf(s).feed),
  write: (s, typed) => {
    const feed = typedFeed(typed);
    return feed === undefined ? null : put(s, "feed", feed);
  },
};

/** M functions as one types them: `M8 M303`, or `8 303`. */
export const functionsField: WordField = {
  id: "functions",
  name: "functions",
  read: (s) =>
    wordsOf(s)
      .functions.map((m) => `M${m}`)
      .join(" "),
  write: (s, typed) => {
    const functions = typedFunctions(typed);
    return functions && withWords(s, { ...wordsOf(s), functions });
  },
};

export const retractField: WordField = {
  id: "retract",
  name: "retract",
  read: (s) => {
    const { retract } = wordsOf(s);
    return retract === "max" ? "MAX" : valueAsTyped(retract);
  },
  write: (s, typed) =>
    /^\s*max\s*$/i.test(typed) ? put(s, "retract", "max") : optionalValue(typed, (value) => put(s, "retract", value)),
};

/** The axes of a block: those that are usual for it, and any other that stands there. */
export const axisFields = (s: Statement, usual: readonly AxisName[]): readonly WordField[] =>
  ORDER.filter((axis) => usual.includes(axis) || wordsOf(s).axes.some((w) => w.axis === axis)).map(axisField);

/** A coordinate of a block that lists its axes and has no other words. */
export function listedAxis(
  axis: AxisName,
  list: (s: Statement) => readonly AxisWord[] | null,
  withList: (s: Statement, axes: readonly AxisWord[]) => Statement,
): WordField {
  const plain = axisField(axis);
  const dressed = (s: Statement): Statement => ({
    kind: "path",
    path: "L",
    words: { ...noWords, axes: list(s) ?? [] },
  });
  const taken = (s: Statement, next: Statement | null | undefined): Statement | null =>
    list(s) && next?.kind === "path" ? withList(s, next.words.axes) : null;
  return {
    ...plain,
    read: (s) => plain.read(dressed(s)),
    write: (s, typed) => taken(s, plain.write(dressed(s), typed)),
    incremental: {
      read: (s) => plain.incremental?.read(dressed(s)) ?? false,
      write: (s, on) => taken(s, plain.incremental?.write(dressed(s), on)) ?? s,
    },
  };
}

const SIGNS: ReadonlyMap<string, number> = new Map([
  ["+", 1],
  ["-", -1],
]);

/** A word that only free contours have: an angle, a centre, a point, the block that a value counts from. */
const freeField = (word: string): WordField => {
  const given = (s: Statement): readonly NamedWord[] => (s.kind === "free" ? s.given : []);
  const set = (s: Statement, value: Value | null): Statement => {
    if (s.kind !== "free") return s;
    const others = s.given.filter((w) => w.name !== word);
    if (value === null) return { ...s, given: others };
    const there = s.given.some((w) => w.name === word);
    return {
      ...s,
      given: there
        ? s.given.map((w) => (w.name === word ? { name: word, value } : w))
        : [...others, { name: word, value }],
    };
  };
  const closes = word === "CLSD";
  return {
    id: `word ${word}`,
    name: { word },
    ...(closes ? { choices: ["", "+", "-"] } : { numeric: true, ...freeUnit(word) }),
    read: (s) => {
      const value = given(s).find((w) => w.name === word)?.value;
      if (!closes || value === undefined) return valueAsTyped(value);
      return value === -1 ? "-" : "+";
    },
    write: (s, typed) => (closes ? set(s, SIGNS.get(typed) ?? null) : optionalValue(typed, (value) => set(s, value))),
  };
};

/** Angles, numbers of blocks, and lengths. */
function freeUnit(word: string): { readonly unit?: string } {
  if (/^(?:PAR|RCC?[XYZ]|RPR|RPA|RAN)$/.test(word)) return {};
  return { unit: /^(?:I?AN|CCPA)$/.test(word) ? "°" : "mm" };
}

/** The words of a free element: those that are usual for its form, and any other that stands there. */
export function freeFields(s: Statement, usual: readonly string[]): readonly WordField[] {
  const there = s.kind === "free" ? s.given.map((w) => w.name) : [];
  return [...new Set([...usual, ...there])].map(freeField);
}

const ANGLES: ReadonlySet<string> = ANGLE_WORDS;
type WithNames = Extract<Statement, { words: readonly NamedWord[] }>;
const hasNames = (s: Statement): s is WithNames => "words" in s && Array.isArray(s.words);

/** A word of the form NAME and value, as undercuts, recesses and corrections have them. */
export const namedField = (word: string, order: readonly string[]): WordField => {
  const words = (s: Statement): readonly NamedWord[] => (hasNames(s) ? s.words : []);
  const set = (s: Statement, value: Value | null): Statement => {
    if (!hasNames(s)) return s;
    const there = s.words.some((w) => w.name === word);
    const next =
      value === null
        ? s.words.filter((w) => w.name !== word)
        : there
          ? s.words.map((w) => (w.name === word ? { name: word, value } : w))
          : [...s.words, { name: word, value }].sort((a, b) => order.indexOf(a.name) - order.indexOf(b.name));
    return { ...s, words: next } as Statement;
  };
  return {
    id: `word ${word}`,
    name: { word },
    numeric: true,
    unit: ANGLES.has(word) ? "°" : "mm",
    read: (s) => valueAsTyped(words(s).find((w) => w.name === word)?.value),
    write: (s, typed) =>
      typed.trim() === "" ? set(s, null) : ((value) => (value === null ? null : set(s, value)))(blockValue(typed)),
  };
};

/** The words of an undercut, recess or correction: those of its form, and any other that stands there. */
export function namedFields(s: Statement, usual: readonly string[]): readonly WordField[] {
  const others = hasNames(s) ? s.words.map((w) => w.name).filter((name) => !usual.includes(name)) : [];
  const order = [...usual, ...others];
  return order.map((name) => namedField(name, order));
}
