/** Tolerances, each with its reason. Their order is tested. All in mm. */

/** Two computed numbers nearer than this are the same number: rounding of doubles, far below anything a control keeps. */
export const ROUND = 1e-9;
/** The polygon engine counts in integers: one unit. Products stay exact up to 949 mm of extent. */
export const GRID = 1e-5;
/** Points nearer than this are one point. Below PRINT, so that rounding cannot split or merge words. */
export const SAME = 1e-4;
/** A control keeps three decimals of an X word, so the finest step on a radius is half of that. */
export const PRINT = 0.0005;
/** How far a chord may leave its arc where arcs become polygons for material removal. */
export const CHORD = 0.001;
/** The polygon proof ignores slivers thinner than this: both sides carry a chord error. */
export const SLIVER = 0.004;
/** The end point of an arc may miss its circle by this much (older controls print 0.016). */
export const ARC_END = 0.016;
