import { rounded } from "../../kernel/units.ts";

/** Smallest usual infeed, mm on the radius. */
export const LEAST_INFEED = 0.05;
/** Above this infeed, the largest usual one is offered, mm. */
export const MOST_INFEED = 20;
/** Usual infeeds and overlaps, mm on the radius or as a share, the largest first. */
export const SETTERS_INFEEDS = [5, 4, 3, 2.5, 2, 1.5, 1, 0.8, 0.5, 0.3, 0.2, 0.1, LEAST_INFEED] as const;
/** Most passes of an offered value. */
export const MOST_PASSES_OFFERED = 100;

/** Usual rounding steps, the coarsest first, mm or degrees. */
const STEPS = [10, 5, 1, 0.5, 0.1, 0.05, 0.01] as const;
/** Tolerance for floating-point errors in a step. */
const DUST = 1e-9;
/** Largest rounding, as a share of the value. */
const SHARE = 0.05;

/** Values near a working one, rounded up (1) or down (-1) as a setter would type, the roundest first. */
export const roundValues = (value: number, way: number): readonly number[] =>
  STEPS.map(
    (step) => rounded(step * (way > 0 ? Math.ceil(value / step - DUST) : Math.floor(value / step + DUST))) + 0,
  ).filter((each) => Math.abs(each - value) <= SHARE * Math.abs(value));
