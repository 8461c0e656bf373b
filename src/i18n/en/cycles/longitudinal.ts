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
  815: {
    name: "Contour-parallel turning",
    summary: "Cuts a free contour by passes that run parallel to it, as on a casting or a forging.",
    description: [
      "Turns a contour from a subprogram. The blank is taken to be the contour with an allowance all round; the passes run along the "
      + "contour, each nearer to it, instead of along the axis.",
      "Roughs, finishes, or both. The direction in which the contour is programmed is the direction of machining. The start point decides "
      + "between outside and inside.",
    ],
    rough: [
      "at rapid in front of the pass",
      "cut along the contour at the roughing feed",
      "retract by the set-up clearance",
      "back in front of the next pass at rapid",
      "repeat until the oversize is reached",
      "back to the cycle start at rapid",
    ],
    finish: [
      "infeed at rapid",
      "finish the contour from start to end",
      "retract by the set-up clearance",
      "back to the cycle start at rapid",
    ],
    notes: [
      turnMode,
      "Cycle 14 must name the contour subprogram before the call.",
      "The first pass lies one infeed below the allowance, wherever the start point stands: a blank that is thicker than its "
      + "allowance is cut deeper there. Our reading; verify on your control.",
      "In an inside corner of the contour a pass takes more than its infeed for a moment: up to a sixth more at a right angle.",
      edgeLength,
    ],
  },
} satisfies CycleTexts;
