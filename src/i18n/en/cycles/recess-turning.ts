import type { CycleTexts } from "../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

export const recessTurning = {
  852: {
    name: "Recess turning, axial, extended",
    summary: "Turns a groove into a face, with leaning walls, chamfers and floor radii.",
    description: [
      "Makes a groove in a face by recess turning: the tool plunges to a depth and then turns sideways, so there are few "
      + "lift-offs. The edges can get a chamfer or a radius, both walls can lean, and the floor corners can be rounded.",
      "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside machining. Smaller: "
      + "inside machining.",
      "If Z of the start point is below the contour start Q492, the tool first moves in Z to Q492.",
    ],
    rough: [
      "plunge to the first depth",
      "cut sideways between start and end at the roughing feed",
      "plunging elements at their own feed",
      "lift, return and approach again (one direction), or feed in at both ends (both directions)",
      "cut to the next depth",
      "repeat until the depth of the groove is reached",
      "rapid to the clearance, then one cut down each wall",
      "back to the cycle start at rapid",
    ],
    finish: [
      "rapid to the first wall",
      "finish the first wall",
      "finish the floor; with a corner radius the whole groove in one go",
      "out of the groove at rapid",
      "rapid to the second wall",
      "finish the second wall",
      "back to the cycle start at rapid",
    ],
    notes: [
      turnMode,
      safePosition,
      "From the second infeed on, each pass is 0.1 mm shorter, or shorter by Q508; this relieves the tool sideways. What stays "
      + "is taken in one cut at the end of roughing.",
      "If the offset passes 80 % of the effective width (edge width minus twice the edge radius), the control stops with an error.",
      edgeLength,
      "The page calls Q460 reserved and still names the set-up clearance in two of its steps; we use a fixed clearance there.",
    ],
  },
} satisfies CycleTexts;
