/** The clearance of recess turning, mm: the manual calls its programmed set-up clearance reserved, so it is fixed. */
export const RECESS_CLEARANCE = 2;
