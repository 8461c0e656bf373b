import type { BlockKind } from "./block-kind.ts";
import type { WordField } from "./field.ts";

/** Which values of a word its page of the guide shows beside the usual one. */
export type Spread =
  /** Its choices, or the texts that are given. */
  | { readonly choices: readonly string[] }
  /** The usual value times each of these. */
  | { readonly times: readonly number[] }
  /** The usual value plus each of these. */
  | { readonly plus: readonly number[] }
  /** One word of the text in place of another, either way. */
  | { readonly swap: readonly [string, string] }
  /** Other tools like the usual one. */
  | { readonly tools: true };

const HALF_AND_DOUBLE: Spread = { times: [0.5, 2] };
const PLACE: Spread = { plus: [-4, 4] };
const TURN: Spread = { plus: [-20, 20] };

/**
 * Words that make another path or part, by the id of their field; where a kind of block has one of its own: kind and
 * field.
 */
const SPREADS: Readonly<Record<string, Spread>> = {
  X: PLACE,
  Z: { plus: [-6, 6] },
  "C.X": { choices: [] },
  "C.Z": { choices: [] },
  "blankBox.X": { plus: [-8, 8] },
  "blankBox.Y": { plus: [-8, 8] },
  "blankCylinder.outside": { times: [0.85, 1.25] },
  "blankCylinder.length": { times: [0.7, 1.4] },
  "blankCylinder.distance": { plus: [2, 5] },
  "blankCylinder.inside": { times: [0.6, 1.4] },
  polarRadius: { plus: [-3, 3] },
  polarAngle: TURN,
  radius: { times: [0.8, 2] },
  "RND.radius": HALF_AND_DOUBLE,
  chamfer: HALF_AND_DOUBLE,
  feed: HALF_AND_DOUBLE,
  cuttingSpeed: HALF_AND_DOUBLE,
  "spin.speed": HALF_AND_DOUBLE,
  speedLimit: { times: [0.3, 2] },
  "toolCall.tool": { tools: true },
  DZL: { plus: [-0.5, 0.5] },
  DXL: { plus: [-0.5, 0.5] },
  DEPTH: { times: [0.5, 1.4] },
  DIAM: { plus: [-1, 2] },
  BREADTH: { times: [0.7, 1.5] },
  "undercut.form": { choices: ["TYPE_E", "TYPE_F", "TYPE_H"] },
  R: HALF_AND_DOUBLE,
  ANGLE: { plus: [-4, 15] },
  "groove.ANGLE": { plus: [-15, 15] },
  "groove.ANG_WIDTH": { plus: [-30, 30] },
  FACEDEPTH: HALF_AND_DOUBLE,
  FACEANGLE: { plus: [-3, 5] },
  ROT: { plus: [-15, 15] },
  "rotation.ROT": { choices: [] },
  PITCH: HALF_AND_DOUBLE,
  CENTER: { plus: [-5, 5] },
  CHF: HALF_AND_DOUBLE,
  RND: HALF_AND_DOUBLE,
  FAR_RND: HALF_AND_DOUBLE,
  FAR_CHF: HALF_AND_DOUBLE,
  repeat: { plus: [-2, 3] },
  formula: PLACE,
  "functions.functions": { swap: ["M136", "M137"] },
};

/** Choices that change neither path nor part here: what they mean is said in words. */
const QUIET: ReadonlySet<string> = new Set([
  "unit",
  "toolAxis",
  "mode",
  "how",
  "blankSource",
  "system",
  "CLSD",
  "groove.form",
]);
/** The only kind of block that compensation is shown at: it begins and ends there. */
const COMPENSATES: BlockKind = "L";

/** A word of a block without what stands in front of it in its id: `word DZL` is DZL. */
export const wordOfField = ({ id }: Pick<WordField, "id">): string => id.replace(/^word /, "");

/** How the values lie that a word is shown with; null where it makes no other path and no other part. */
export function spreadOf(kind: BlockKind, field: Pick<WordField, "id" | "choices">): Spread | null {
  const word = wordOfField(field);
  const spread = SPREADS[`${kind}.${word}`] ?? SPREADS[word];
  const isQuiet = QUIET.has(word) || QUIET.has(`${kind}.${word}`) || (word === "compensation" && kind !== COMPENSATES);
  const choices = isQuiet ? [] : (field.choices ?? []).filter((choice) => choice !== "");
  const found: Spread = field.choices && !(spread && !isQuiet) ? { choices } : (spread ?? { choices: [] });
  return "choices" in found && found.choices.length === 0 ? null : found;
}

const PLACES = 3;
const rounded = (n: number): string => String(Number(n.toFixed(PLACES)));

/**
 * The texts that a word is shown with, the usual one among them, in their order; only that one where it is no plain
 * number.
 */
export function textsBeside(spread: Spread, usual: string): readonly string[] {
  if ("choices" in spread) return spread.choices.includes(usual) ? spread.choices : [usual, ...spread.choices];
  if ("tools" in spread) return [usual];
  if ("swap" in spread) {
    const [a, b] = spread.swap,
      other = usual.includes(a) ? usual.replace(a, b) : usual.replace(b, a);
    return [...new Set([usual, other])];
  }
  const value = usual.trim() === "" ? NaN : Number(usual);
  if (!Number.isFinite(value)) return [usual];
  const others = "times" in spread ? spread.times.map((by) => value * by) : spread.plus.map((by) => value + by);
  const all = [...new Set([usual, ...others.map(rounded)])];
  return all.toSorted((a, b) => Number(a) - Number(b));
}
