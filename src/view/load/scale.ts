import { ROUND } from "../../kernel/tolerance.ts";

/** Tones of a scale, from the least to the most. A scale of fewer classes takes those that lie farthest apart. */
export const SCALE_TONES = 7;
/** Steps between the ends of classes: one of these, or so many powers of ten of it. */
const NICE = [1, 2, 2.5, 5] as const;
/** Values that differ by less than this share are one class. */
const ALIKE = 0.02;

/** Classes of a quantity by round numbers: class i goes from the bound i up to the bound i + 1. */
export interface Scale {
  readonly bounds: readonly number[];
}

/** Removes the floating-point error of a multiple of a round number. */
const clean = (value: number) => Number(value.toPrecision(12));

/**
 * At most seven classes of equal size that cover `low` to `high`; one class if all values are the same. The bounds are
 * round in units of `unit`.
 */
export function scaleOf(low: number, high: number, unit = 1): Scale {
  return unit === 1
    ? roundScale(low, high)
    : { bounds: roundScale(low / unit, high / unit).bounds.map((each) => each * unit) };
}

function roundScale(low: number, high: number): Scale {
  if (!(high > low * (1 + ALIKE)) || !(high > 0)) return { bounds: [clean(low), clean(high)] };
  for (let power = Math.floor(Math.log10((high - low) / SCALE_TONES)); ; power += 1) {
    for (const nice of NICE) {
      const size = nice * 10 ** power;
      const [first, last] = [Math.floor(low / size + ROUND), Math.ceil(high / size - ROUND)];
      if (last - first <= SCALE_TONES)
        return { bounds: Array.from({ length: last - first + 1 }, (_, i) => clean((first + i) * size)) };
    }
  }
}

export const classesOf = ({ bounds }: Scale): number => Math.max(1, bounds.length - 1);

/** The class of a value: on a bound the one above it, at the very end the last. */
export function classAt(scale: Scale, value: number): number {
  const above = scale.bounds.findIndex((bound) => bound > value + ROUND);
  return Math.min(classesOf(scale) - 1, Math.max(0, (above < 0 ? scale.bounds.length : above) - 1));
}

/**
 * The tone of a class, 0 to SCALE_TONES − 1: the last class always has the strongest, a single one that of the middle.
 */
export function classTone(scale: Scale, index: number): number {
  const last = classesOf(scale) - 1;
  return last === 0 ? (SCALE_TONES - 1) / 2 : Math.round((index * (SCALE_TONES - 1)) / last);
}
