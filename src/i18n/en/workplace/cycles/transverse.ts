import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, freeContour, plunging, safePosition, turnMode } from "./notes.ts";

const rough = [
  "paraxial infeed at rapid traverse",
  "transverse cut at the roughing feed",
  "retract by the infeed",
  "return to the start of the cut at rapid traverse",
  "repeat until the contour is reached",
  "return to the cycle start at rapid traverse",
];
const finish = [
  "infeed at rapid traverse",
  "finish the contour from start to end",
  "retract by the set-up clearance",
  "return to the cycle start at rapid traverse",
];
/** Steps and notes of the cycles that describe the contour by parameters. */
const own = { rough, finish, notes: [turnMode, safePosition, edgeLength] };

export const transverse = {
  820: {
    name: "Contour, transverse",
    summary: "Cuts a free contour from a subprogram, across the axis.",
    description: [
      "Turns any contour transversely. The contour is a subprogram of lines, roundings, chamfers and arcs, " +
        "selected by cycle 14 or SEL CONTOUR.",
      "Roughs with paraxial passes, finishes, or both. X of the contour start greater than X of the contour end: " +
        "outside machining. " +
        "Smaller: inside machining.",
      "If Z of the start point is below the contour start, the tool first moves in Z to the contour start; for " +
        "finishing, to the " +
        "set-up clearance.",
    ],
    rough,
    finish,
    notes: freeContour,
  },
  821: {
    name: "Shoulder, face",
    summary: "Faces a square shoulder across the axis, from the tool position.",
    description: [
      "Turns a face and the cylinder at its end. The tool position at the call is one corner of the area to be " +
        "machined, the programmed end is the other; there are no angles, chamfers or roundings.",
      "Roughs with paraxial passes across the axis, finishes, or both. Start point farther from the axis than " +
        "Q493: outside " +
        "machining. Nearer: inside machining.",
    ],
    ...own,
  },
  822: {
    name: "Shoulder, face, extended",
    summary: "Faces a shoulder across the axis, with chamfers, angles and a corner radius.",
    description: [
      "Turns a shoulder transversely. The edges at the contour start and end can have a chamfer or a radius, the " +
        "face and the circumferential surface can be inclined, and the inside corner can be rounded.",
      "Roughs with paraxial passes across the axis, finishes, or both. Start diameter greater than end diameter: " +
        "outside " +
        "machining. Smaller: inside machining.",
      "If the start point is in the area to be machined, the tool first moves in Z, then in X, to the set-up " +
        "clearance.",
    ],
    ...own,
  },
  823: {
    name: "Plunge turning, transverse",
    summary: "Cuts behind a flank into a face, across the axis.",
    description: [
      "Turns an area in a face that the tool can only reach by plunging: down a flank at the contour start, " +
        "across a floor, " +
        "and up to a perpendicular wall at the end.",
      "Material next to the contour start is not machined; it remains in the plane of Q492.",
      "Roughs with paraxial passes across the axis, finishes, or both. Start diameter greater than end diameter: " +
        "outside " +
        "machining. Smaller: inside machining.",
      "If the start point is in the area to be machined, the tool first moves in Z, then in X, to the set-up " +
        "clearance next to the contour start.",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
  824: {
    name: "Plunge turning, transverse, extended",
    summary: "Cuts behind a flank into a face, with chamfers, radii and an inclined wall.",
    description: [
      "Turns an area in a face that the tool can only reach by plunging: down a flank at the contour start, " +
        "across a floor, " +
        "and up a wall at the end. The edges at both ends can have a chamfer or a radius, both corners on the " +
        "floor can be rounded, and the wall can be inclined.",
      "Material next to the contour start is not machined; it remains in the plane of Q492.",
      "Roughs with paraxial passes across the axis, finishes, or both. Start diameter greater than end diameter: " +
        "outside " +
        "machining. Smaller: inside machining.",
      "If the start point is in the area to be machined, the tool first moves in Z, then in X, to the set-up " +
        "clearance next to the contour start.",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
} satisfies CycleTexts;
