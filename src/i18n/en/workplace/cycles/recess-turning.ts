import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

const rough = [
  "plunge to the first depth",
  "cut sideways between start and end at the roughing feed",
  "plunging elements at their own feed",
  "one direction: lift, return, approach again; both: feed in at both ends",
  "cut to the next depth",
  "repeat until the depth of the groove is reached",
  "rapid to the clearance, then one cut down each wall",
  "back to the cycle start at rapid",
];
const finish = [
  "rapid to the first wall",
  "finish the first wall",
  "finish the floor; with a corner radius the whole groove in one go",
  "out of the groove at rapid",
  "rapid to the second wall",
  "finish the second wall",
  "back to the cycle start at rapid",
];
const shortened =
  "From the second infeed on, each pass is 0.1 mm shorter, or shorter by Q508; this relieves the tool sideways. What stays " +
  "is taken in one cut at the end of roughing.";
const tooFar =
  "If the offset passes 80 % of the effective width (edge width minus twice the edge radius), the control stops with an error.";
const recalled = [
  "The parameter list is recalled from the twin that is printed, and so are the steps. Our reading; verify on your control.",
  "Q460 is taken to be reserved, as in cycle 852; a fixed clearance is kept instead.",
];
const notes = [turnMode, safePosition, shortened, tooFar, edgeLength, ...recalled];

export const recessTurning = {
  840: {
    name: "Recess turning, radial, contour",
    summary: "Turns the recesses of a programmed contour into a cylinder or a bore, valley by valley.",
    description: [
      "Removes the material over a contour from a subprogram (cycle 14 or SEL CONTOUR) by recess turning: the tool plunges and " +
        "then turns sideways. A contour with several valleys is cut section by section, from the contour start on.",
      "Roughs with paraxial passes, finishes, or both. Start point farther out than the contour: outside machining. Nearer to " +
        "the axis: inside machining.",
      "If X of the start point lies nearer to the floor than the highest point of the contour, the tool first moves in X to it.",
    ],
    rough,
    finish,
    notes: [
      ...notes,
      "Q509 shifts the whole contour in depth, since it has no one floor; finishing takes a steep wall out of a sharp corner " +
        "from its top down. Our reading; verify on your control.",
    ],
  },
  841: {
    name: "Recess turning, radial, simple",
    summary: "Turns a groove with upright walls into a cylinder or a bore, from the start point to one corner.",
    description: [
      "Makes a groove in a cylinder, or in a bore, between the start point of the cycle and the corner Q493, Q494. The start " +
        "point is the first corner of the groove: its X is the opening, its Z the first wall.",
      "Roughs with paraxial passes, finishes, or both. Start point farther out than Q493: outside machining. Nearer to the " +
        "axis: inside machining.",
    ],
    rough,
    finish,
    notes,
  },
  842: {
    name: "Recess turning, radial, extended",
    summary: "Turns a groove into a cylinder or a bore, with leaning walls, chamfers and floor radii.",
    description: [
      "Makes a groove in a cylinder, or in a bore, by recess turning: the tool plunges to a depth and then turns sideways, so " +
        "there are few lift-offs. The edges can get a chamfer or a radius, both walls can lean, and the floor corners can be " +
        "rounded.",
      "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside machining. Smaller: " +
        "inside machining.",
      "If X of the start point lies nearer to the floor than the start diameter Q491, the tool first moves in X to Q491.",
    ],
    rough,
    finish,
    notes,
  },
  850: {
    name: "Recess turning, axial, contour",
    summary: "Turns the recesses of a programmed contour into a face, valley by valley.",
    description: [
      "Removes the material over a contour from a subprogram (cycle 14 or SEL CONTOUR) by recess turning: the tool plunges and " +
        "then turns sideways. A contour with several valleys is cut section by section, from the contour start on.",
      "Roughs with paraxial passes, finishes, or both. The face is worked from +Z; from −Z where the tool points to +Z and " +
        "stands behind the contour.",
      "If Z of the start point lies below the highest point of the contour, the tool first moves in Z to it.",
    ],
    rough,
    finish,
    notes: [
      ...notes,
      "Q509 shifts the whole contour in depth, since it has no one floor; finishing takes a steep wall out of a sharp corner " +
        "from its top down. Our reading; verify on your control.",
    ],
  },
  851: {
    name: "Recess turning, axial, simple",
    summary: "Turns a groove with upright walls into a face, from the start point to one corner.",
    description: [
      "Makes a groove in a face between the start point of the cycle and the corner Q493, Q494. The start point is the first " +
        "corner of the groove: its Z is the opening, its X the first wall.",
      "Roughs with paraxial passes, finishes, or both. Start point farther out than Q493: the groove is cut inwards. Nearer to " +
        "the axis: outwards.",
    ],
    rough,
    finish,
    notes,
  },
  852: {
    name: "Recess turning, axial, extended",
    summary: "Turns a groove into a face, with leaning walls, chamfers and floor radii.",
    description: [
      "Makes a groove in a face by recess turning: the tool plunges to a depth and then turns sideways, so there are few " +
        "lift-offs. The edges can get a chamfer or a radius, both walls can lean, and the floor corners can be rounded.",
      "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside machining. Smaller: " +
        "inside machining.",
      "If Z of the start point is below the contour start Q492, the tool first moves in Z to Q492.",
    ],
    rough,
    finish,
    notes: [
      turnMode,
      safePosition,
      shortened,
      tooFar,
      edgeLength,
      "The page calls Q460 reserved and still names the set-up clearance in two of its steps; we use a fixed clearance there.",
    ],
  },
} satisfies CycleTexts;
