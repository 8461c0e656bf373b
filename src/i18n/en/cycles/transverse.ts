import type { CycleTexts } from "../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

export const transverse = {
  820: {
    name: "Contour, transverse",
    summary: "Cuts a free contour from a subprogram, across the axis.",
    description: [
      "Turns any contour crosswise. The contour stands in a subprogram of lines, roundings, chamfers and arcs, named by cycle 14 "
      + "or SEL CONTOUR.",
      "Roughs with paraxial passes, finishes, or both. First contour point greater in X than the last: outside machining. "
      + "Smaller: inside machining.",
      "If Z of the start point is below the contour start, the tool first moves in Z to the contour start; for finishing, to the "
      + "set-up clearance.",
    ],
    rough: [
      "paraxial infeed at rapid",
      "cut crosswise at the roughing feed",
      "retract by the infeed",
      "back to the start of the cut at rapid",
      "repeat until the contour is reached",
      "back to the cycle start at rapid",
    ],
    finish: [
      "infeed at rapid",
      "finish the contour from start to end",
      "retract by the set-up clearance",
      "back to the cycle start at rapid",
    ],
    notes: [
      "Danger of collision: the machining limit restricts the contour that is cut, but approach and departure may cross it. "
      + "Stand the tool, before the call, on the side of the limit that is to be cut.",
      turnMode,
      safePosition,
      "The shape of the insert is taken into account so that no element is damaged. What the tool cannot reach stays, with a warning.",
      "Cycle 14 with the label of the contour, or SEL CONTOUR with its file, must stand before the call.",
      "Local parameters (QL) used in the contour must be set in the contour subprogram itself.",
      edgeLength,
    ],
  },
} satisfies CycleTexts;
