/** Tolerances, each with its reason. Their order is tested. All in mm. */

/** Computed numbers nearer than this are equal: rounding of doubles, far below the resolution of a control. */
export const ROUND = 1e-9;
/** Smaller values, in mm, radians or as a slope, are zero: they give no direction and must not be a divisor. */
export const NOTHING = 1e-12;
/**
 * Heights and ends computed in different ways, as by an envelope and along its contour, are joined when they are this
 * near.
 */
export const JOINED = 1e-7;
/**
 * One unit of the polygon engine, which counts in integers. Results are exact whatever the extent: up to 949 mm
 * products fit into a double; larger areas, such as finished parts, are multiplied as big integers, which is slower.
 */
export const GRID = 1e-5;
/**
 * Points nearer than this are one point. A control keeps three decimals of an X word, so the finest step on a radius is
 * 0.0005. The tolerance is smaller, so that rounding cannot split or merge words.
 */
export const SAME = 1e-4;
/**
 * Greatest deviation of a listed size in mm that an inch program states with four decimals, including its own rounding.
 */
export const INCH_ROUNDED = 0.01;
/** Greatest distance of a chord from its arc where arcs become polygons for material removal. */
export const CHORD = 0.001;
/** The polygon check ignores thinner slivers: both sides have a chord error. */
export const SLIVER = 0.004;
/** The end point of an arc may be this far off its circle (older controls print 0.016). */
export const ARC_END = 0.016;
/**
 * A size within this share of a step counts as that step: the rounding error of sums and products of printed numbers.
 */
export const SAME_STEP = 1e-6;
