/** Smaller differences of two ways are none: mm² and s. */
export const SAME_AREA = 0.05;
export const SAME_TIME = 0.05;
