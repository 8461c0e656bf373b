/** Tolerances, each with its reason. Their order is tested. All in mm. */

/**
 * Two computed numbers nearer than this are the same number: rounding of doubles, far below anything a control keeps.
 */
export const ROUND = 1e-9;
/**
 * Less than this, mm, radians or a slope, is nothing: there is no direction to take from it and nothing to divide by.
 */
export const NOTHING = 1e-12;
/**
 * Heights and ends that were worked out in different ways, as by an envelope and along its contour, join when they are
 * this near.
 */
export const JOINED = 1e-7;
/**
 * The polygon engine counts in integers: one unit. Results are exact whatever the extent: up to 949 mm products fit
 * into a double; areas that reach farther, as finished parts do, are multiplied as big integers, which is slower.
 */
export const GRID = 1e-5;
/**
 * Points nearer than this are one point. A control keeps three decimals of an X word, so the finest step on a radius is
 * 0.0005: this is below it, so that rounding cannot split or merge words.
 */
export const SAME = 1e-4;
/**
 * A size of a list in mm that an inch program writes with four decimals, with what is left of it by its own rounding.
 */
export const INCH_ROUNDED = 0.01;
/** How far a chord may leave its arc where arcs become polygons for material removal. */
export const CHORD = 0.001;
/** The polygon proof ignores slivers thinner than this: both sides carry a chord error. */
export const SLIVER = 0.004;
/** The end point of an arc may miss its circle by this much (older controls print 0.016). */
export const ARC_END = 0.016;
/**
 * A size this part of a step beside a step of a control is that step: what sums and products of printed numbers round
 * off.
 */
export const SAME_STEP = 1e-6;
