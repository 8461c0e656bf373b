/**
 * Turning cycles that are read, shown and preserved, but not simulated: their labels in the order in which a control
 * writes them, as recalled (probably right).
 */
const UNSIMULATED = {
  880:
    "Q215 MACHINING OPERATION, Q540 MODULE, Q541 NUMBER OF TEETH, Q542 OUTSIDE DIAMETER, Q563 TOOTH HEIGHT, " +
    "Q543 TROUGH-TIP CLEARANCE, Q544 ANGLE OF INCLINATION, Q545 TOOL LEAD ANGLE, Q546 CHANGE ROT DIRECTION, " +
    "Q547 ANG. OFFSET SPINDLE, Q550 MACHINING SIDE, Q533 PREFERRED DIRECTION, Q530 INCLINED MACHINING, Q253 F PRE-POSITIONING, " +
    "Q260 CLEARANCE HEIGHT, Q553 TOOL LENGTH OFFSET, Q551 STARTING POINT IN Z, Q552 END POINT IN Z, Q463 MAX. CUTTING DEPTH, " +
    "Q460 SAFETY CLEARANCE, Q488 PLUNGING FEED RATE, Q478 ROUGHING FEED RATE, Q483 OVERSIZE FOR DIAMETER, " +
    "Q505 FINISHING FEED RATE",
  882:
    "Q499 REVERSE CONTOUR, Q558 EXT:ANGLE CONT.START, Q559 CONTOUR END EXT ANGL, Q478 ROUGHING FEED RATE, " +
    "Q488 PLUNGING FEED RATE, Q556 MIN. INCLINAT. ANGLE, Q557 MAX. INCLINAT. ANGLE, Q567 FINISH. ALLOW. CONT., Q519 INFEED, " +
    "Q463 MAX. CUTTING DEPTH, Q590 MACHINING MODE, Q591 MACHINING SEQUENCE, Q389 UNI.- BIDIRECTIONAL",
  883:
    "Q460 SAFETY CLEARANCE, Q499 REVERSE CONTOUR, Q558 EXT:ANGLE CONT.START, Q559 CONTOUR END EXT ANGL, " +
    "Q505 FINISHING FEED RATE, Q556 MIN. INCLINAT. ANGLE, Q557 MAX. INCLINAT. ANGLE, Q555 STEPPING ANGLE, " +
    "Q537 INCID. ANGLE ACTIVE, Q538 INCLIN. ANGLE START, Q539 INCLINATN. ANGLE END, Q565 FINISHING ALLOW. D., " +
    "Q566 FINISHING ALLOW. Z, Q567 FINISH. ALLOW. CONT.",
  892: "Q450 MAXIMUM RUNOUT, Q451 SPEED",
} as const;

/** Numbers of these cycles: a number without a name is a compile error in each language. */
export type UnsimulatedNumber = keyof typeof UNSIMULATED;

export const unsimulatedNumbers = Object.keys(UNSIMULATED).map(Number) as UnsimulatedNumber[];
export const isUnsimulated = (cycle: number): cycle is UnsimulatedNumber => unsimulatedNumbers.some((n) => n === cycle);

/** The parameters of such a cycle with their labels, in order. */
export const labelsOfUnsimulated = (cycle: UnsimulatedNumber): ReadonlyMap<string, string> =>
  new Map(
    UNSIMULATED[cycle].split(", ").map((line) => [line.slice(0, line.indexOf(" ")), line.slice(line.indexOf(" ") + 1)]),
  );
