import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, freeContour, plunging, safePosition, turnMode } from "./notes.ts";

const rough = [
  "paraxial infeed at rapid",
  "cut crosswise at the roughing feed",
  "retract by the infeed",
  "back to the start of the cut at rapid",
  "repeat until the contour is reached",
  "back to the cycle start at rapid",
];
const finish = [
  "infeed at rapid",
  "finish the contour from start to end",
  "retract by the set-up clearance",
  "back to the cycle start at rapid",
];
/** Of the cycles that have a contour of their own. */
const own = { rough, finish, notes: [turnMode, safePosition, edgeLength] };

export const transverse = {
  820: {
    name: "Contour, transverse",
    summary: "Cuts a free contour from a subprogram, across the axis.",
    description: [
      "Turns any contour crosswise. The contour stands in a subprogram of lines, roundings, chamfers and arcs, named by cycle 14 " +
        "or SEL CONTOUR.",
      "Roughs with paraxial passes, finishes, or both. First contour point greater in X than the last: outside machining. " +
        "Smaller: inside machining.",
      "If Z of the start point is below the contour start, the tool first moves in Z to the contour start; for finishing, to the " +
        "set-up clearance.",
    ],
    rough,
    finish,
    notes: freeContour,
  },
  821: {
    name: "Shoulder, face",
    summary: "Faces a square shoulder across the axis, from where the tool stands.",
    description: [
      "Turns a face and the cylinder at its end. The point where the tool stands at the call is one corner of the area to be " +
        "cut, the programmed end is the other; there are no angles and no broken edges.",
      "Roughs with paraxial passes across the axis, finishes, or both. Start point farther from the axis than Q493: outside " +
        "machining. Nearer: inside machining.",
    ],
    ...own,
  },
  822: {
    name: "Shoulder, face, extended",
    summary: "Faces a shoulder across the axis, with chamfers, angles and a corner radius.",
    description: [
      "Turns a shoulder crosswise. The edges at the contour start and end can get a chamfer or a radius, the face and the " +
        "circumferential surface can lean, and the inside corner can be rounded.",
      "Roughs with paraxial passes across the axis, finishes, or both. Start diameter greater than end diameter: outside " +
        "machining. Smaller: inside machining.",
      "If the start point lies in the area to be cut, the tool first moves in Z, then in X, to the set-up clearance.",
    ],
    ...own,
  },
  823: {
    name: "Plunge turning, transverse",
    summary: "Cuts behind a flank into a face, across the axis.",
    description: [
      "Turns an area in a face that the tool can only reach by plunging: down a flank at the contour start, across a floor, " +
        "and up to a square wall at the end.",
      "What stands beside the contour start stays, in the plane of Q492. Our reading; verify on your control.",
      "Roughs with paraxial passes across the axis, finishes, or both. Start diameter greater than end diameter: outside " +
        "machining. Smaller: inside machining.",
      "If the start point lies in the area to be cut, the tool first moves in Z, then in X, to the set-up clearance beside " +
        "the contour start.",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
  824: {
    name: "Plunge turning, transverse, extended",
    summary: "Cuts behind a flank into a face, with broken edges, corner radii and a leaning wall.",
    description: [
      "Turns an area in a face that the tool can only reach by plunging: down a flank at the contour start, across a floor, " +
        "and up a wall at the end. The edges at either end can get a chamfer or a radius, both corners on the floor can be " +
        "rounded, and the wall can lean.",
      "What stands beside the contour start stays, in the plane of Q492. Our reading; verify on your control.",
      "Roughs with paraxial passes across the axis, finishes, or both. Start diameter greater than end diameter: outside " +
        "machining. Smaller: inside machining.",
      "If the start point lies in the area to be cut, the tool first moves in Z, then in X, to the set-up clearance beside " +
        "the contour start.",
    ],
    rough,
    finish,
    notes: [...own.notes, plunging],
  },
} satisfies CycleTexts;
