import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, freeContour, plunging, safePosition, turnMode } from "./notes.ts";

const rough = [
  "paraxial infeed at rapid",
  "cut lengthwise at the roughing feed",
  "retract by the infeed",
  "back to the start of the cut at rapid",
  "repeat until the contour is reached",
  "back to the cycle start at rapid",
];
const finish = [
  "paraxial infeed at rapid",
  "finish the contour from start to end",
  "retract by the set-up clearance",
  "back to the cycle start at rapid",
];
const notes = [turnMode, safePosition, edgeLength];

export const longitudinal = {
  810: {
    name: "Contour, longitudinal",
    summary: "Cuts a free contour from a subprogram, along the axis.",
    description: [
      "Turns any contour lengthwise: shafts and bores with shoulders, tapers, arcs, undercuts and grooves. The contour " +
        "stands in a subprogram, named by cycle 14 or SEL CONTOUR.",
      "Roughs with paraxial passes, finishes, or both. A start point farther from the axis than the contour: outside " +
        "machining. Nearer to it: inside machining. Between the two the tool decides, by the way its tip points. Our reading; " +
        "verify on your control.",
      "The contour is cut in the direction in which it is programmed. If X of the start point lies below the contour start, " +
        "the tool first moves in X to the contour start; for finishing, to the set-up clearance.",
    ],
    rough,
    finish,
    notes: freeContour,
  },
  811: {
    name: "Shoulder, longitudinal",
    summary: "Cuts a square shoulder along the axis, from where the tool stands.",
    description: [
      "Turns a cylinder and the face behind it. The point where the tool stands at the call is one corner of the area to be " +
        "cut, the programmed end is the other; there are no angles and no broken edges.",
      "Roughs with paraxial passes, finishes, or both. Start point farther from the axis than Q493: outside machining. " +
        "Nearer: inside machining.",
    ],
    rough,
    finish,
    notes,
  },
  812: {
    name: "Shoulder, longitudinal, extended",
    summary: "Cuts a shoulder along the axis, with chamfers, angles and a corner radius.",
    description: [
      "Turns a shoulder lengthwise. The edges at the contour start and end can get a chamfer or a radius, the circumferential " +
        "surface and the face can lean, and the inside corner can be rounded.",
      "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside machining. Smaller: " +
        "inside machining.",
      "If the start point lies in the area to be cut, the tool first moves in X, then in Z, to the set-up clearance. For " +
        "finishing it first moves in Z to the set-up clearance.",
    ],
    rough,
    finish,
    notes,
  },
  813: {
    name: "Plunge turning, longitudinal",
    summary: "Cuts behind a flank into a cylinder, along the axis.",
    description: [
      "Turns an area that the tool can only reach by plunging: down a flank at the contour start, along a cylinder, and up " +
        "to a square face at the end.",
      "What stands in front of the contour start stays, at the height of Q491. Our reading; verify on your control.",
      "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside machining. Smaller: " +
        "inside machining.",
      "If the start point lies in the area to be cut, the tool first moves in X, then in Z, to the set-up clearance in front " +
        "of the contour start.",
    ],
    rough,
    finish,
    notes: [...notes, plunging],
  },
  814: {
    name: "Plunge turning, longitudinal, extended",
    summary: "Cuts behind a flank into a cylinder, with broken edges, corner radii and a leaning face.",
    description: [
      "Turns an area that the tool can only reach by plunging: down a flank at the contour start, along a cylinder, and up a " +
        "face at the end. The edges at either end can get a chamfer or a radius, both corners on the cylinder can be rounded, " +
        "and the face can lean.",
      "What stands in front of the contour start stays, at the height of Q491. Our reading; verify on your control.",
      "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside machining. Smaller: " +
        "inside machining.",
      "If the start point lies in the area to be cut, the tool first moves in X, then in Z, to the set-up clearance in front " +
        "of the contour start.",
    ],
    rough,
    finish,
    notes: [...notes, plunging],
  },
  815: {
    name: "Contour-parallel turning",
    summary: "Cuts a free contour by passes that run parallel to it, as on a casting or a forging.",
    description: [
      "Turns a contour from a subprogram. The blank is taken to be the contour with an allowance all round; the passes run along the " +
        "contour, each nearer to it, instead of along the axis.",
      "Roughs, finishes, or both. The direction in which the contour is programmed is the direction of machining. The start point decides " +
        "between outside and inside.",
      "If the start point lies behind the contour start, the tool first moves in Z to the set-up clearance in front of it, in roughing and " +
        "in finishing.",
    ],
    rough: [
      "infeed at rapid in front of the pass",
      "cut along the contour at the roughing feed",
      "back to the start point in X at the roughing feed",
      "to the beginning of the next pass at rapid",
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
      "The first pass lies one infeed below the allowance, wherever the start point stands: a blank that is thicker than its " +
        "allowance is cut deeper there. Our reading; verify on your control.",
      "The manual page decides between outside and inside by contour start and contour end. Here the side of the start point decides: " +
        "by the page, a shaft that gets thicker towards the chuck would be inside machining. Verify on your control.",
      "In an inside corner of the contour a pass takes more than its infeed for a moment: up to a sixth more at a right angle.",
      edgeLength,
    ],
  },
} satisfies CycleTexts;
