import type { CycleTexts } from "../../../cycle-text.ts";
import { safePosition, turnMode } from "./notes.ts";

const rough = [
  "plunge into solid at the feed in solid, down to the oversize",
  "dwell on the floor, then retract",
  "lateral step by the overlap, in front of the workpiece",
  "plunge next to the previous cut at the roughing feed",
  "repeat until the width is reached, then cut along inclined or curved walls",
  "return to the cycle start at rapid traverse",
];
const finish = [
  "to the first side at rapid traverse",
  "finish the first wall",
  "finish half of the floor, then lift off",
  "out of the recess at rapid traverse",
  "to the second side at rapid traverse",
  "finish the second wall",
  "finish the other half of the floor, then lift off",
  "return to the cycle start at rapid traverse",
];
const order =
  "Roughs from the floor of the recess to one wall and back to the other, finishes, or both. In comb recessing " +
  "the full cuts come first, then the webs between them.";
const notes = [
  turnMode,
  safePosition,
  "If the flat part of the edge (width minus twice the radius) is at least half the width, the step between two " +
    "plunges is never greater than this part: no ridges remain.",
  "A recess deeper than CUTLENGTH is machined only to that depth, with a message.",
  "Parameter list and steps are not verified against a manual; check on your control.",
];
const sections =
  "A contour with several valleys is machined section by section: floor and walls of one section before the next.";

export const recessing = {
  860: {
    name: "Recessing of a contour, radial",
    summary: "Plunges a contour into a cylinder or a bore, with any number of recesses.",
    description: [
      "Removes the material between a contour from a subprogram and the start point with plunges towards the " +
        "axis; in a bore, away from the axis. Cycle 14 selects the contour.",
      order,
      sections,
    ],
    rough,
    finish,
    notes,
  },
  861: {
    name: "Recessing, radial, simple",
    summary: "Plunges a recess with perpendicular walls into a cylinder or a bore, from the start point to one corner.",
    description: [
      "Machines a recess in a cylinder or a bore between the start point of the cycle and the corner Q493, Q494, " +
        "with plunges side by side. The start point is the first corner of the recess.",
      order,
    ],
    rough,
    finish,
    notes,
  },
  862: {
    name: "Recessing, radial, extended",
    summary: "Plunges a recess into a cylinder or a bore, with inclined walls, chamfers and floor radii.",
    description: [
      "Machines a recess in a cylinder or a bore with plunges side by side. The edges can have a chamfer or a " +
        "radius, both walls can be inclined, and the floor corners can be rounded.",
      order,
    ],
    rough,
    finish,
    notes,
  },
  870: {
    name: "Recessing of a contour, axial",
    summary: "Plunges a contour into a face, with any number of recesses.",
    description: [
      "Removes the material between a contour from a subprogram and the start point with plunges along the axis. " +
        "Cycle 14 selects the contour.",
      order,
      sections,
    ],
    rough,
    finish,
    notes,
  },
  871: {
    name: "Recessing, axial, simple",
    summary: "Plunges a recess with perpendicular walls into a face, from the start point to one corner.",
    description: [
      "Machines a recess in a face between the start point of the cycle and the corner Q493, Q494, with plunges " +
        "side by side. The start point is the first corner of the recess.",
      order,
    ],
    rough,
    finish,
    notes,
  },
  872: {
    name: "Recessing, axial, extended",
    summary: "Plunges a recess into a face, with inclined walls, chamfers and floor radii.",
    description: [
      "Machines a recess in a face with plunges side by side. The edges can have a chamfer or a radius, both " +
        "walls can be inclined, and the floor corners can be rounded.",
      order,
    ],
    rough,
    finish,
    notes,
  },
} satisfies CycleTexts;
