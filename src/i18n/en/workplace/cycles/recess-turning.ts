import type { CycleTexts } from "../../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

const rough = [
  "plunge to the first depth",
  "lateral cut between start and end at the roughing feed",
  "plunging elements at the plunging feed",
  "one direction: lift off, return, approach again; both directions: infeed at both ends",
  "cut to the next depth",
  "repeat until the depth of the recess is reached",
  "to the set-up clearance at rapid traverse, then one cut down each wall",
  "return to the cycle start at rapid traverse",
];
const finish = [
  "to the first wall at rapid traverse",
  "finish the first wall",
  "finish the floor; with a corner radius the whole recess in one cut",
  "out of the recess at rapid traverse",
  "to the second wall at rapid traverse",
  "finish the second wall",
  "return to the cycle start at rapid traverse",
];
const shortened =
  "From the second infeed on, each pass is 0.1 mm shorter, or shorter by Q508; this reduces the lateral load on " +
  "the tool. The residual material is removed in one cut at the end of roughing.";
const tooFar =
  "If the offset exceeds 80 % of the effective width (edge width minus twice the edge radius), the control stops " +
  "with an error.";
const unverified = [
  "Parameter list and steps follow the related printed cycle and are not verified against a manual; check on " +
    "your control.",
  "Q460 is treated as reserved, as in cycle 852; a fixed clearance is used instead.",
];
const notes = [turnMode, safePosition, shortened, tooFar, edgeLength, ...unverified];

export const recessTurning = {
  840: {
    name: "Recess turning, radial, contour",
    summary: "Turns the recesses of a programmed contour into a cylinder or a bore, one contour valley after another.",
    description: [
      "Removes the material over a contour from a subprogram (cycle 14 or SEL CONTOUR) by recess turning: the " +
        "tool plunges, then turns laterally. A contour with several valleys is machined section by section, " +
        "beginning at the contour start.",
      "Roughs with paraxial passes, finishes, or both. Start point farther out than the contour: outside " +
        "machining. Nearer to " +
        "the axis: inside machining.",
      "If X of the start point is nearer to the floor than the highest point of the contour, the tool first " +
        "moves in X to that point.",
    ],
    rough,
    finish,
    notes: [
      ...notes,
      "Q509 shifts the whole contour in depth, since its floor is not level throughout; a steep wall that ends " +
        "in a sharp corner is finished from top to bottom.",
    ],
  },
  841: {
    name: "Recess turning, radial, simple",
    summary: "Turns a recess with perpendicular walls into a cylinder or a bore, from the start point to one corner.",
    description: [
      "Machines a recess in a cylinder or a bore between the start point of the cycle and the corner Q493, Q494. " +
        "The start " +
        "point is the first corner of the recess: its X is the opening, its Z the first wall.",
      "Roughs with paraxial passes, finishes, or both. Start point farther out than Q493: outside machining. " +
        "Nearer to the " +
        "axis: inside machining.",
    ],
    rough,
    finish,
    notes,
  },
  842: {
    name: "Recess turning, radial, extended",
    summary: "Turns a recess into a cylinder or a bore, with inclined walls, chamfers and floor radii.",
    description: [
      "Machines a recess in a cylinder or a bore by recess turning: the tool plunges to a depth, then turns " +
        "laterally, with few retractions. The edges can have a chamfer or a radius, both walls can be inclined, " +
        "and the floor corners can be rounded.",
      "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside " +
        "machining. Smaller: " +
        "inside machining.",
      "If X of the start point is nearer to the floor than the start diameter Q491, the tool first moves in X to Q491.",
    ],
    rough,
    finish,
    notes,
  },
  850: {
    name: "Recess turning, axial, contour",
    summary: "Turns the recesses of a programmed contour into a face, one contour valley after another.",
    description: [
      "Removes the material over a contour from a subprogram (cycle 14 or SEL CONTOUR) by recess turning: the " +
        "tool plunges, then turns laterally. A contour with several valleys is machined section by section, " +
        "beginning at the contour start.",
      "Roughs with paraxial passes, finishes, or both. The face is machined from +Z; it is machined from −Z if " +
        "the tool points to +Z and is behind the contour.",
      "If Z of the start point is below the highest point of the contour, the tool first moves in Z to that point.",
    ],
    rough,
    finish,
    notes: [
      ...notes,
      "Q509 shifts the whole contour in depth, since its floor is not level throughout; a steep wall that ends " +
        "in a sharp corner is finished from top to bottom.",
    ],
  },
  851: {
    name: "Recess turning, axial, simple",
    summary: "Turns a recess with perpendicular walls into a face, from the start point to one corner.",
    description: [
      "Machines a recess in a face between the start point of the cycle and the corner Q493, Q494. The start " +
        "point is the first corner of the recess: its Z is the opening, its X the first wall.",
      "Roughs with paraxial passes, finishes, or both. Start point farther out than Q493: the recess is machined " +
        "inwards. Nearer to " +
        "the axis: outwards.",
    ],
    rough,
    finish,
    notes,
  },
  852: {
    name: "Recess turning, axial, extended",
    summary: "Turns a recess into a face, with inclined walls, chamfers and floor radii.",
    description: [
      "Machines a recess in a face by recess turning: the tool plunges to a depth, then turns laterally, with " +
        "few retractions. The edges can have a chamfer or a radius, both walls can be inclined, and the floor " +
        "corners can be rounded.",
      "Roughs with paraxial passes, finishes, or both. Start diameter greater than end diameter: outside " +
        "machining. Smaller: " +
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
      "The manual calls Q460 reserved, but names the set-up clearance in two steps; a fixed clearance is used there.",
      "Not printed, hence unverified: the direction of Q495 and Q496, the sign of Q509, and that the offsets of " +
        "Q508 add up per side.",
    ],
  },
} satisfies CycleTexts;
