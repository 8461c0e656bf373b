import type { Cycle, Given, Outline } from "./define.ts";
import { neutralOf, type SomeValues } from "./effect.ts";
import { firstValues } from "./first-values.ts";
import type { Param, Params, Values } from "./params.ts";

/** What a few values of a cycle draw together with others in place of those that are missing. */
export interface Completion {
  readonly values: Values<Params>;
  readonly outline: Outline;
}

/** A position on the contour: a diameter or a Z that a shop drawing would have. */
export const isPosition = ({ kind, shown }: Param): boolean =>
  (kind === "diameter" || kind === "axial") && shown === "outline";

/** It corrects what a drawing says: as long as it is missing, nothing is corrected. */
const isCorrection = ({ shown }: Param): boolean => shown === "depthCompensation";

/**
 * How long a part is taken to be, on the radius or along Z, where nothing says it: against its radius, and at least,
 * mm.
 */
const [SHARE, LEAST] = [0.4, 5];

/**
 * How far what is missing lies from what is typed, in such lengths, with the direction of the example or against it;
 * far where a wall that leans needs the room, and near where it would take too much of it.
 */
const WAYS = [1, 0.73, -1, -0.61, 2.9, 11.3, -3.1, -9.7, 0.29, -0.23] as const;

/**
 * How much longer than wide the rest is, one after the other: a wall that leans far fits only into what is long, or
 * short. Below zero it goes the other way along Z: a contour that is cut as in the example may rise where that falls.
 */
const STRETCH = [1, 3.7, -1, 0.27, 1.9, -4.3] as const;

/** Small sizes and angles that are tried one after the other, so that they fit whatever is typed: mm, degrees. */
const SIZES = [0, 0.0137, 0.031, 0.0473] as const;

const typedOf = (known: SomeValues, q: string): number | null => (typeof known[q] === "number" ? known[q] : null);

/** Positions in place of those that are missing, from those of the same kind that are typed. */
function positionsFor(
  params: Params,
  known: SomeValues,
  example: Readonly<Record<string, number>>,
  way: number,
  stretch = 1,
): Record<string, number> {
  const all = Object.entries(params).filter(([, p]) => isPosition(p));
  const typed = (kind: Param["kind"]) => all.flatMap(([q, p]) => (p.kind === kind ? (typedOf(known, q) ?? []) : []));
  const apart = (list: readonly number[]) => Math.abs((list[0] ?? 0) - (list[1] ?? list[0] ?? 0));
  const radii = typed("diameter"),
    lengths = typed("axial");
  const usual = Math.max(LEAST, (SHARE * Math.max(0, ...radii.map(Math.abs))) / 2);
  const size = apart(radii) / 2 || apart(lengths) || usual;
  return Object.fromEntries(
    all.flatMap(([q, p]): [string, number][] => {
      if (typedOf(known, q) !== null) return [];
      const other = all.find(([o, { kind }]) => kind === p.kind && typedOf(known, o) !== null)?.[0];
      if (other === undefined) return [[q, (example[q] ?? 0) + (way === WAYS[0] ? 0 : way * LEAST)]];
      const from = typedOf(known, other) ?? 0;
      const sign = Math.sign((example[q] ?? 0) - (example[other] ?? 0)) || 1;
      const found = from + sign * way * size * (p.kind === "diameter" ? 2 : stretch);
      return [[q, p.kind === "diameter" && found <= 0 ? Math.abs(from) / (2 + Math.abs(way)) : found]];
    }),
  );
}

const inRange = ({ range: [min, max] }: Param, n: number): number => Math.min(max, Math.max(min, n));

/**
 * A small value in place of one that is missing, another one with each number; of a choice each of its values in turn.
 */
function smallOf(p: Param, n: number): number {
  if (isCorrection(p)) return neutralOf(p);
  if (p.choices) return p.choices[n % p.choices.length] as number;
  return inRange(p, neutralOf(p) + (SIZES[n % SIZES.length] as number));
}

const isPossible = (outline: Outline) =>
  outline.contour.length > 0 && !outline.issues.some((found) => found.severity === "error");

/** Values and their outline; null where they make no contour. */
function completion(cycle: Cycle, values: SomeValues, given: Given): Completion | null {
  const whole = values as Values<Params>;
  const outline = cycle.outline(whole, given);
  return isPossible(outline) ? { values: whole, outline } : null;
}

/** How often each missing value is drawn anew: every choice comes up, with each direction of the rest. */
const DRAWS = STRETCH.length * WAYS.length;

/**
 * Contours that agree with a few values and differ in everything that is missing, but for corrections. One where
 * nothing is; none where so little fits that a missing value is the same in all of them.
 */
export function completions(cycle: Cycle, known: SomeValues, given: Given): readonly Completion[] {
  const missing = Object.entries<Param>(cycle.params).filter(([q]) => known[q] === undefined);
  const example = firstValues(cycle);
  const draws = missing.length === 0 ? 1 : DRAWS;
  const made = Array.from({ length: draws }, (_, n) => {
    const way = WAYS[n % WAYS.length] as number;
    const round = Math.floor(n / WAYS.length);
    const rest = Object.fromEntries(missing.map(([q, p], i) => [q, smallOf(p, round + (p.choices ? 0 : i))]));
    return completion(
      cycle,
      { ...rest, ...positionsFor(cycle.params, known, example, way, STRETCH[round % STRETCH.length]), ...known },
      given,
    );
  }).flatMap((one) => one ?? []);
  const differs = (q: string) => made.some(({ values }) => values[q] !== made[0]?.values[q]);
  return missing.every(([q, p]) => isCorrection(p) || differs(q)) ? made : [];
}

/**
 * Values to draw a few typed ones with, as a control's own help does: what is missing is as it was before, or else has
 * the look of the example, in proportion to what is typed. Null where the typed ones make no contour whatever the
 * others are.
 */
export function likelyCompletion(
  cycle: Cycle,
  known: SomeValues,
  given: Given,
  before: SomeValues | null = null,
): Completion | null {
  const kept = before && completion(cycle, { ...before, ...known }, given);
  if (kept) return kept;
  const example = firstValues(cycle);
  const plain = Object.fromEntries(
    Object.entries<Param>(cycle.params).map(([q, p]) => [q, isPosition(p) ? (example[q] ?? 0) : neutralOf(p)]),
  );
  for (const rest of [example, plain])
    for (const way of WAYS) {
      const made = completion(cycle, { ...rest, ...positionsFor(cycle.params, known, example, way), ...known }, given);
      if (made) return made;
    }
  return completion(cycle, { ...example, ...known }, given);
}

/** The contour of the positions alone, with square walls and sharp corners; null while a position is missing. */
export function plainCompletion(cycle: Cycle, known: SomeValues, given: Given): Completion | null {
  const missing = Object.entries<Param>(cycle.params).filter(([q]) => known[q] === undefined);
  if (missing.some(([, p]) => isPosition(p))) return null;
  return completion(cycle, { ...Object.fromEntries(missing.map(([q, p]) => [q, neutralOf(p)])), ...known }, given);
}
