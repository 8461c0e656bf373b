import { valueText } from "../number-text.ts";
import { feedText } from "../print-words.ts";
import type { AxisWord, PolarWord, Value, Words } from "../words.ts";
import { LAYOUTS } from "../style.ts";
import { coordinateTexts, type IsoCoordinate } from "./coordinates.ts";
import { isoWordFor } from "./words.ts";

/** Numbers of DIN/ISO: signed as in Klartext, with a decimal point. */
export const ISO_STYLE = LAYOUTS.tnc7;

/** A value that carries no plus sign in Klartext carries none here. */
export const bareValue = (value: Value) => valueText(value, { ...ISO_STYLE, plus: false });
export const signedValue = (value: Value) => valueText(value, ISO_STYLE);

export const coordinatesOfAxes = (axes: readonly AxisWord[]): IsoCoordinate[] =>
  axes.map((w) => ({ ...w, name: w.axis }));
export const polarCoordinates = ({ polarRadius, polarAngle }: Words): IsoCoordinate[] => [
  ...polar("R", polarRadius),
  ...polar("H", polarAngle),
];
const polar = (name: string, w: PolarWord | undefined) => (w ? [{ ...w, name }] : []);

const compensationTexts = ({ compensation }: Words): string[] =>
  compensation === undefined ? [] : [isoWordFor({ kind: "compensation", value: compensation }) ?? ""];

/** Feed, M functions and their words; `rapid`: the path function already implies FMAX. */
export function tailTexts(words: Words, rapid = false): string[] {
  const { feed, functions, retract, functionFeed } = words;
  return [
    ...(feed === undefined || (rapid && feed === "max") ? [] : [feedText(feed, ISO_STYLE)]),
    ...functions.map((m) => `M${bareValue(m)}`),
    ...(retract === undefined ? [] : [`MB${retract === "max" ? " MAX" : signedValue(retract)}`]),
    ...(functionFeed === undefined ? [] : [feedText(functionFeed, ISO_STYLE)]),
  ];
}

/** Parts of a block besides its words. */
interface BlockParts {
  /** G word in front; none for a block of I, J and K. */
  readonly word?: string | null;
  readonly coordinates?: readonly IsoCoordinate[];
  /** Words behind the coordinates. */
  readonly more?: readonly string[];
  /** The G word implies FMAX. */
  readonly rapid?: boolean;
}

/** A block: its G word, compensation, coordinates, a radius, feed and M functions. */
export const wordsBlock = (words: Words, { word, coordinates = [], more = [], rapid = false }: BlockParts): string =>
  [
    ...(word ? [word] : []),
    ...compensationTexts(words),
    ...coordinateTexts(coordinates),
    ...more,
    ...tailTexts(words, rapid),
  ].join(" ");

type Part = keyof Words;
const TAIL: readonly Part[] = ["compensation", "feed", "functions", "retract", "functionFeed"];

/** True when a block has only the named parts, compensation, feed and M functions. */
export const saysOnly = (words: Words, ...parts: readonly Part[]): boolean =>
  (Object.keys(words) as Part[]).every((key) => {
    const of = words[key];
    return of === undefined || (Array.isArray(of) && of.length === 0) || TAIL.includes(key) || parts.includes(key);
  });
