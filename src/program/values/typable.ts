import { rounded } from "../../kernel/units.ts";

/** The smallest infeed that a setter types, mm on the radius. */
export const LEAST_INFEED = 0.05;
/** More than this nobody takes at once: there the largest usual one is offered, mm. */
export const MOST_INFEED = 20;
/** Infeeds and overlaps that a setter types, mm on the radius or as a share, the largest first. */
export const SETTERS_INFEEDS = [5, 4, 3, 2.5, 2, 1.5, 1, 0.8, 0.5, 0.3, 0.2, 0.1, LEAST_INFEED] as const;
/** Nobody waits for more passes than these. */
export const MOST_PASSES_OFFERED = 100;

/** Steps that a setter counts in, the coarsest first, mm or degrees. */
const STEPS = [10, 5, 1, 0.5, 0.1, 0.05, 0.01] as const;
/** Rounding of doubles moves no value to the next step. */
const DUST = 1e-9;
/** A value is rounded by this part of itself at most. */
const SHARE = 0.05;

/** Values near to one that works, rounded up (1) or down (-1) to what a setter would type, the roundest first. */
export const typable = (value: number, way: number): readonly number[] =>
  STEPS.map(
    (step) => rounded(step * (way > 0 ? Math.ceil(value / step - DUST) : Math.floor(value / step + DUST))) + 0,
  ).filter((each) => Math.abs(each - value) <= SHARE * Math.abs(value));
