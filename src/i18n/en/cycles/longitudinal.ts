import type { CycleTexts } from "../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

export const longitudinal = {
  812: {
    name: "Shoulder, longitudinal, extended",
    summary: "Cuts a shoulder along the axis, with chamfers, angles and a corner radius.",
    description: [
      "Turns a shoulder lengthwise. The edges at the contour start and end can get a chamfer or a radius, the circumferential "
      + "surface and the face can lean, and the inside corner can be rounded.",
      "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside machining. Smaller: "
      + "inside machining.",
      "If the start point lies in the area to be cut, the tool first moves in X, then in Z, to the set-up clearance. For "
      + "finishing it first moves in Z to the set-up clearance.",
    ],
    rough: [
      "paraxial infeed at rapid",
      "cut lengthwise at the roughing feed",
      "retract by the infeed",
      "back to the start of the cut at rapid",
      "repeat until the contour is reached",
      "back to the cycle start at rapid",
    ],
    finish: [
      "paraxial infeed at rapid",
      "finish the contour from start to end",
      "retract by the set-up clearance",
      "back to the cycle start at rapid",
    ],
    notes: [turnMode, safePosition, edgeLength],
  },
} satisfies CycleTexts;
