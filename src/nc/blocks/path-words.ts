import { valueText } from "../number-text.ts";
import { feedText, wordsText, type Signs } from "../print-words.ts";
import { readWords } from "../read-words.ts";
import type { AxisName, AxisWord, PolarWord, Words } from "../words.ts";
import type { Style } from "../style.ts";
import { within, type Field, type FieldFacts, type Unseen, type ValueField, type Word } from "./define.ts";
import { BARE, type ComparedWords } from "./compared-words.ts";
import { choiceField, plainFeedField, word } from "./words.ts";

type Fields<Name extends string> = readonly Field<Words, Name>[];

/** Sets or removes a word: null removes it. */
function put<K extends keyof Words>(words: Words, key: K, value: Words[K] | null): Words {
  const { [key]: _, ...rest } = words;
  return (value === null || value === undefined ? rest : { ...rest, [key]: value }) as Words;
}

const ORDER: readonly AxisName[] = ["X", "Y", "Z", "A", "B", "C", "U", "V", "W"];
const rank = (w: AxisWord) => ORDER.indexOf(w.axis);
/** The name of an axis: a text for three of them, the letter for all others. */
type AxisText = "x" | "y" | "z";
const NAMES: Partial<Record<AxisName, AxisText>> = { X: "x", Y: "y", Z: "z" };
const SPREADS = { X: { plus: [-4, 4] }, Z: { plus: [-6, 6] } } as const;
const isCut = (axis: AxisName): axis is "X" | "Z" => axis === "X" || axis === "Z";

/** A coordinate of a list, with its switch for incremental. mm. */
export function axisField(axis: AxisName): Field<readonly AxisWord[], AxisText> {
  const find = (axes: readonly AxisWord[]) => axes.find((w) => w.axis === axis);
  const set = (axes: readonly AxisWord[], next: AxisWord): readonly AxisWord[] =>
    find(axes) ? axes.map((w) => (w.axis === axis ? next : w)) : [...axes, next].sort((a, b) => rank(a) - rank(b));
  return {
    id: axis,
    name: NAMES[axis] ?? { word: axis },
    unit: "mm",
    about: "axis",
    ...(isCut(axis) ? { spread: SPREADS[axis] } : { noPicture: "axis" }),
    entry: "value",
    get: (axes) => find(axes)?.value ?? null,
    put: (axes, value) =>
      value === null
        ? axes.filter((w) => w.axis !== axis)
        : set(axes, { axis, value, incremental: find(axes)?.incremental ?? false }),
    incremental: {
      read: (axes) => find(axes)?.incremental ?? false,
      write: (axes, on) => {
        const there = find(axes);
        return there ? set(axes, { ...there, incremental: on }) : axes;
      },
    },
  };
}

const AXES = ["X", "Y", "Z"] as const satisfies readonly AxisName[];
/** The three axes of a block that lists them and has no other words. */
export const listFields = AXES.map(axisField);
export const axesText = (axes: readonly AxisWord[], style: Style): string =>
  axes.map((w) => ` ${w.incremental ? "I" : ""}${w.axis}${valueText(w.value, style)}`).join("");

/** The axes of a block: the usual ones, and any other axis of the block. */
export const axisFields = ({ axes }: Words, usual: readonly AxisName[] = AXES): Fields<AxisText> =>
  ORDER.filter((axis) => usual.includes(axis) || axes.some((w) => w.axis === axis)).map((axis) =>
    within(
      axisField(axis),
      (words: Words) => words.axes,
      (words, next) => ({ ...words, axes: next }),
    ),
  );

type Valued = "radius" | "centreAngle" | "length";
const valueField = <const N extends string>(
  key: Valued,
  name: N,
  facts: Pick<FieldFacts, "unit" | "letter" | "spread">,
): ValueField<Words, "value", N> => ({
  id: key,
  name,
  unit: "mm",
  ...facts,
  entry: "value",
  get: (words) => words[key] ?? null,
  put: (words, value) => put(words, key, value),
});

export const radiusField = valueField("radius", "radius", { letter: "R", spread: { times: [0.8, 2] } });
export const lineLengthField = valueField("length", "lineLength", { letter: "LEN" });
export const centreAngleField = valueField("centreAngle", "centreAngle", { letter: "CCA", unit: "°" });

const polarField = <K extends "polarRadius" | "polarAngle">(
  key: K,
  facts: Pick<FieldFacts, "unit" | "letter" | "spread">,
): ValueField<Words, "value", K> => {
  const find = (words: Words): PolarWord | undefined => words[key];
  return {
    id: key,
    name: key,
    ...facts,
    entry: "value",
    get: (words) => find(words)?.value ?? null,
    put: (words, value) =>
      put(words, key, value === null ? null : { value, incremental: find(words)?.incremental ?? false }),
    incremental: {
      read: (words) => find(words)?.incremental ?? false,
      write: (words, on) => {
        const there = find(words);
        return there ? put(words, key, { ...there, incremental: on }) : words;
      },
    },
  };
};
export const polarRadiusField = polarField("polarRadius", { unit: "mm", letter: "PR", spread: { plus: [-3, 3] } });
export const polarAngleField = polarField("polarAngle", { unit: "°", letter: "PA", spread: { plus: [-20, 20] } });
export const polarFields = [polarRadiusField, polarAngleField];

export const turnField: Field<Words, "turn"> = {
  ...choiceField<Words, "turn">(
    "turn",
    ["", "cw", "ccw"],
    (words) => words.turn ?? "",
    (chosen, words) => put(words, "turn", chosen === "cw" || chosen === "ccw" ? chosen : null),
  ),
  letter: "DR",
};

/** Compensation is offered at straight lines only, where it begins and ends. */
const compensationField: Field<Words, "compensation"> = {
  ...choiceField<Words, "compensation">(
    "compensation",
    ["", "R0", "RL", "RR"],
    (words) => words.compensation ?? "",
    (chosen, words) =>
      put(words, "compensation", chosen === "R0" || chosen === "RL" || chosen === "RR" ? chosen : null),
  ),
  letter: "RL/RR",
  noPicture: "compensation",
};

export const feedField: Field<Words, "feed"> = within(
  plainFeedField,
  (words: Words) => words.feed ?? null,
  (words, feed) => put(words, "feed", feed),
);

export const functionsField: Field<Words, "functions"> = {
  id: "functions",
  name: "functions",
  letter: "M",
  noPicture: "functions",
  entry: "functions",
  get: (words) => words.functions,
  put: (words, functions) => ({ ...words, functions }),
};

export const retractField: Field<Words, "retract"> = {
  id: "retract",
  name: "retract",
  letter: "MB",
  entry: "retract",
  get: (words) => words.retract ?? null,
  put: (words, retract) => put(words, "retract", retract),
};

/** The fields at the end of nearly every path block. */
export const tailFields = [compensationField, feedField, functionsField];
export const straightTailFields = [
  { ...compensationField, spread: { choices: ["R0", "RL", "RR"] } } satisfies Field<Words, "compensation">,
  feedField,
  functionsField,
];
/** The same field without a picture, with the reason. */
export const withoutPicture = <N extends string>({ spread: _, ...field }: Field<Words, N>, noPicture: Unseen) =>
  ({ ...field, noPicture }) as Field<Words, N>;

/** All words of a path block. */
export function comparePathWords(words: Words, said: ComparedWords): void {
  said.axes(words.axes).polar("PR", words.polarRadius).polar("PA", words.polarAngle);
  said.number("CCA", words.centreAngle).number("LEN", words.length).number("R", words.radius);
  if (words.turn) said.put("DR", words.turn === "ccw" ? "+" : "-");
  said.axes(words.linear ?? [], "LIN_").put("", words.compensation);
  if (words.feed) said.feed("F", words.feed);
  if (words.functions.length > 0) said.put("M", words.functions.toSorted((a, b) => a - b).join(", "));
  if (words.retract === "max") said.put("MB", "MAX");
  else if (words.retract !== undefined) said.signed("MB", words.retract);
  if (words.functionFeed) said.put("M F", feedText(words.functionFeed, BARE));
  for (const each of words.extra ?? []) said.text("", each);
}

/** The words of a path block up to its end. `fields`: those that a form asks for. */
export const pathWords = <const N extends string>(
  fields: (words: Words, statement: never) => Fields<N>,
  {
    wide = true,
    signs = () => ({ length: true, radius: true }),
  }: { readonly wide?: boolean; readonly signs?: (statement: never) => Signs } = {},
): Word<"words", Words, N> =>
  word("words", {
    take: readWords,
    text: (words, style, s) => wordsText(words, wide ? style : { ...style, wide: false }, signs(s)),
    compareAs: comparePathWords,
    fields,
  });

/** The axes of a block in one word. */
export const axesIn = (words: Words): string =>
  words.axes
    .map(({ axis }) => axis)
    .sort()
    .join("");
