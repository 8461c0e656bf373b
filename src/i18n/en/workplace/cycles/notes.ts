export const turnMode =
  "Runs only in FUNCTION MODE TURN. On a TNC7 the machine builder must have enabled the function.";
export const safePosition =
  "Before the call, position the tool with R0 at a safe position: this is the cycle start and determines the " +
  "area to be machined.";
export const edgeLength =
  "CUTLENGTH in the tool table limits the roughing infeed; a larger infeed is reduced, with a warning.";
/** Notes of every cycle that takes its contour from a subprogram. */
export const freeContour = [
  "Danger of collision: the machining limit restricts the machined contour, but approach and departure may cross " +
    "it. Before the call, position the tool on the side of the limit that is to be machined.",
  turnMode,
  safePosition,
  "The insert geometry is taken into account so that no contour element is damaged. Where the tool cannot reach, " +
    "residual material remains, with a warning.",
  "Cycle 14 with the label of the contour, or SEL CONTOUR with its file, must be programmed before the call.",
  "Local parameters (QL) used in the contour must be set in the contour subprogram itself.",
  edgeLength,
];
/** Note of the cycles that plunge without a plunging feed. */
export const plunging =
  "The tool plunges at the roughing feed: these cycles have no separate plunging feed. On a flank steeper than " +
  "the insert can follow, residual material remains, with a warning.";
/** Note of cycle 812: a printed list, with one fact that the page leaves open. */
export const inclination =
  "Not printed, hence unverified: the direction in which Q495 and Q496 incline surface and face.";
