import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, freeContour, inclination, plunging, safePosition, turnMode } from "./notes.ts";

const rough = [
  "paraxial infeed at rapid traverse",
  "longitudinal cut at the roughing feed",
  "retract by the infeed",
  "return to the start of the cut at rapid traverse",
  "repeat until the contour is reached",
  "return to the cycle start at rapid traverse",
];
const finish = [
  "paraxial infeed at rapid traverse",
  "finish the contour from start to end",
  "retract by the set-up clearance",
  "return to the cycle start at rapid traverse",
];
const notes = [turnMode, safePosition, edgeLength];

export const longitudinal = {
  810: {
    name: "Contour, longitudinal",
    summary: "Cuts a free contour from a subprogram, along the axis.",
    description: [
      "Turns any contour longitudinally: shafts and bores with shoulders, tapers, arcs, undercuts and grooves. " +
        "The contour is a subprogram, selected by cycle 14 or SEL CONTOUR.",
      "Roughs with paraxial passes, finishes, or both. A start point farther from the axis than the contour: outside " +
        "machining. Nearer to it: inside machining. In between, the tool orientation decides.",
      "The contour is machined in the programmed direction. If X of the start point is below the contour start, " +
        "the tool first moves in X to the contour start; for finishing, to the set-up clearance.",
    ],
    rough,
    finish,
    notes: freeContour,
  },
  811: {
    name: "Shoulder, longitudinal",
    summary: "Cuts a square shoulder along the axis, from the tool position.",
    description: [
      "Turns a cylinder and the face behind it. The tool position at the call is one corner of the area to be " +
        "machined, the programmed end is the other; there are no angles, chamfers or roundings.",
      "Roughs with paraxial passes, finishes, or both. Start point farther from the axis than Q493: outside " +
        "machining. " +
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
      "Turns a shoulder longitudinally. The edges at the contour start and end can have a chamfer or a radius, " +
        "the circumferential surface and the face can be inclined, and the inside corner can be rounded.",
      "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside " +
        "machining. Smaller: " +
        "inside machining.",
      "If the start point is in the area to be machined, the tool first moves in X, then in Z, to the set-up " +
        "clearance. For " +
        "finishing it first moves in Z to the set-up clearance.",
    ],
    rough,
    finish,
    notes: [...notes, inclination],
  },
  813: {
    name: "Plunge turning, longitudinal",
    summary: "Cuts behind a flank into a cylinder, along the axis.",
    description: [
      "Turns an area that the tool can only reach by plunging: down a flank at the contour start, along a " +
        "cylinder, and up to a perpendicular face at the end.",
      "Material in front of the contour start is not machined; it remains at the height of Q491.",
      "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside " +
        "machining. Smaller: " +
        "inside machining.",
      "If the start point is in the area to be machined, the tool first moves in X, then in Z, to the set-up " +
        "clearance in front " +
        "of the contour start.",
    ],
    rough,
    finish,
    notes: [...notes, plunging],
  },
  814: {
    name: "Plunge turning, longitudinal, extended",
    summary: "Cuts behind a flank into a cylinder, with chamfers, radii and an inclined face.",
    description: [
      "Turns an area that the tool can only reach by plunging: down a flank at the contour start, along a " +
        "cylinder, and up a " +
        "face at the end. The edges at both ends can have a chamfer or a radius, both corners on the cylinder " +
        "can be rounded, and the face can be inclined.",
      "Material in front of the contour start is not machined; it remains at the height of Q491.",
      "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside " +
        "machining. Smaller: " +
        "inside machining.",
      "If the start point is in the area to be machined, the tool first moves in X, then in Z, to the set-up " +
        "clearance in front " +
        "of the contour start.",
    ],
    rough,
    finish,
    notes: [...notes, plunging],
  },
  815: {
    name: "Contour-parallel turning",
    summary: "Cuts a free contour with passes parallel to it, as on a casting or a forging.",
    description: [
      "Turns a contour from a subprogram. The blank is assumed to be the contour plus an allowance all round; " +
        "the passes run along the contour, each nearer to it, instead of along the axis.",
      "Roughs, finishes, or both. The programmed direction of the contour is the machining direction. The start " +
        "point decides between outside and inside machining.",
      "If the start point is behind the contour start, the tool first moves in Z to the set-up clearance in " +
        "front of it, for roughing and finishing.",
    ],
    rough: [
      "infeed at rapid traverse in front of the pass",
      "cut along the contour at the roughing feed",
      "return to the start point in X at the roughing feed",
      "to the start of the next pass at rapid traverse",
      "repeat until the oversize is reached",
      "return to the cycle start at rapid traverse",
    ],
    finish: [
      "infeed at rapid traverse",
      "finish the contour from start to end",
      "retract by the set-up clearance",
      "return to the cycle start at rapid traverse",
    ],
    notes: [
      turnMode,
      "Cycle 14 must select the contour subprogram before the call.",
      "The first pass is one infeed below the allowance, regardless of the start point: where the blank is " +
        "thicker than the allowance, the cut is deeper.",
      "The manual distinguishes outside and inside machining by contour start and contour end; here the side of " +
        "the start point decides. By the manual, a shaft that gets thicker towards the chuck would be inside " +
        "machining. Unverified.",
      "In an inside corner of the contour a pass briefly cuts deeper than its infeed: by up to one sixth at a " +
        "right angle.",
      edgeLength,
    ],
  },
} satisfies CycleTexts;
