export const turnMode =
  "Runs only in FUNCTION MODE TURN. On a TNC7 the machine builder must have enabled the function.";
export const safePosition =
  "Before the call, position the tool with R0 at a safe place: that point is the cycle start and decides how much is cut.";
export const edgeLength =
  "A CUTLENGTH in the tool table limits the infeed in roughing; the infeed is then reduced, with a warning.";
/** What holds for every cycle that takes its contour from a subprogram. */
export const freeContour = [
  "Danger of collision: the machining limit restricts the contour that is cut, but approach and departure may cross it. " +
    "Stand the tool, before the call, on the side of the limit that is to be cut.",
  turnMode,
  safePosition,
  "The shape of the insert is taken into account so that no element is damaged. What the tool cannot reach stays, with a warning.",
  "Cycle 14 with the label of the contour, or SEL CONTOUR with its file, must stand before the call.",
  "Local parameters (QL) used in the contour must be set in the contour subprogram itself.",
  edgeLength,
];
/** What holds where a tool plunges and no feed is asked for it. */
export const plunging =
  "The tool plunges at the roughing feed: these cycles ask for no feed of its own. A flank steeper than the insert can " +
  "follow keeps material, with a warning.";
