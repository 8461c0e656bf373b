export const turnMode = "Runs only in FUNCTION MODE TURN. On a TNC7 the machine builder must have enabled the function.";
export const safePosition =
  "Before the call, position the tool with R0 at a safe place: that point is the cycle start and decides how much is cut.";
export const edgeLength = "A CUTLENGTH in the tool table limits the infeed in roughing; the infeed is then reduced, with a message.";
