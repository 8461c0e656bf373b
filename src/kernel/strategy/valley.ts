/** The clearance of recess turning, mm: the manual calls its programmed set-up clearance reserved, so it is fixed. */
export const RECESS_CLEARANCE = 2;

/** Lift of the tool from a height: by the clearance, but no higher than the start point. All mm. */
export const liftUnder = (top: number, v: number, clearance = RECESS_CLEARANCE) =>
  Math.max(0, Math.min(clearance, top - v));
