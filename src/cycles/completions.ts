import type { Cycle, Given, Outline } from "./define.ts";
import { neutralValueOf, type SomeValues } from "./effect.ts";
import { firstValues } from "./first-values.ts";
import type { Param, Params, Values } from "./params.ts";

/** The outline of a few values, with substitutes for the missing ones. */
export interface Completion {
  readonly values: Values<Params>;
  readonly outline: Outline;
}

/** A position on the contour: a diameter or a Z as on a shop drawing. */
export const isPosition = ({ kind, shown }: Param): boolean =>
  (kind === "diameter" || kind === "axial") && shown === "outline";

/** A correction of the drawing: while it is missing, nothing is corrected. */
const isCorrection = ({ shown }: Param): boolean => shown === "depthCompensation";

/**
 * Assumed extent of a part on the radius or along Z, where no value states it: as a share of its radius, and at least,
 * mm.
 */
const [SHARE, LEAST] = [0.4, 5];

/**
 * Distance of a missing position from a typed one, in such extents, in the example's direction or against it: far where
 * a sloping wall needs the room, near where it would take too much of it.
 */
const WAYS = [1, 0.73, -1, -0.61, 2.9, 11.3, -3.1, -9.7, 0.29, -0.23] as const;

/**
 * Length-to-width ratios that are tried in turn: a steep or a flat wall fits only certain proportions. Negative values
 * reverse Z: a contour cut as in the example may rise where that one falls.
 */
const STRETCH = [1, 3.7, -1, 0.27, 1.9, -4.3] as const;

/** Small sizes and angles that are tried in turn to fit the typed values: mm, degrees. */
const SIZES = [0, 0.0137, 0.031, 0.0473] as const;

const typedOf = (known: SomeValues, q: string): number | null => (typeof known[q] === "number" ? known[q] : null);

/** Substitutes for missing positions, from typed positions of the same kind. */
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

/** A substitute for a small missing value, different for each number; for a choice, its values in turn. */
function smallOf(p: Param, n: number): number {
  if (isCorrection(p)) return neutralValueOf(p);
  if (p.choices) return p.choices[n % p.choices.length] as number;
  return inRange(p, neutralValueOf(p) + (SIZES[n % SIZES.length] as number));
}

const isPossible = (outline: Outline) =>
  outline.contour.length > 0 && !outline.issues.some((found) => found.severity === "error");

/** Values and their outline; null where they make no contour. */
function completion(cycle: Cycle, values: SomeValues, given: Given): Completion | null {
  const whole = values as Values<Params>;
  const outline = cycle.outline(whole, given);
  return isPossible(outline) ? { values: whole, outline } : null;
}

/** Number of draws: every choice is drawn with every direction of the other values. */
const DRAWS = STRETCH.length * WAYS.length;

/**
 * Contours that share the typed values and differ in everything that is missing, except corrections. A single one where
 * nothing is missing; none where a missing value would be the same in all of them.
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
 * Substitutes for drawing a few typed values, as a control's own help does: missing values are the previous ones, or
 * have the proportions of the example. Null where the typed values allow no contour.
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
    Object.entries<Param>(cycle.params).map(([q, p]) => [q, isPosition(p) ? (example[q] ?? 0) : neutralValueOf(p)]),
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
  return completion(cycle, { ...Object.fromEntries(missing.map(([q, p]) => [q, neutralValueOf(p)])), ...known }, given);
}
