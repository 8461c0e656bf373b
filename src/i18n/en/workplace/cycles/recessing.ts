import type { CycleTexts } from "../../../cycle-text.ts";
import { safePosition, turnMode } from "./notes.ts";

const rough = [
  "plunge into the solid at the feed for it, to the depth with its oversize",
  "dwell on the floor, then out of the cut",
  "sideways by the overlap, in front of the work",
  "plunge beside what is cut already, at the roughing feed",
  "repeat until the width is reached, then cut along walls that lean or are round",
  "back to the cycle start at rapid",
];
const finish = [
  "rapid to the first side",
  "finish the first wall",
  "finish half of the floor, then lift",
  "out of the groove at rapid",
  "rapid to the second side",
  "finish the second wall",
  "finish the other half of the floor, then lift",
  "back to the cycle start at rapid",
];
const order =
  "Roughs from the floor of the groove to one wall and back to the other, finishes, or both. With comb recessing " +
  "the full cuts come first, then the webs between them.";
const notes = [
  turnMode,
  safePosition,
  "Two plunges never lie farther apart than the level part of the edge (its width minus twice its radius) where " +
    "that is half of it or more: so no crests stay between them.",
  "A groove that is deeper than CUTLENGTH is cut as deep as the edge is long, with a message.",
  "The parameter list and the steps are recalled; no page we hold prints them. Our reading; verify on your control.",
];
const sections =
  "A contour with several valleys is cut section by section, each to its floor and along its walls before the next.";

export const recessing = {
  860: {
    name: "Recessing of a contour, radial",
    summary: "Plunges a contour into a cylinder or a bore, with any number of grooves.",
    description: [
      "Takes what lies between the contour of a subprogram and the start point, by plunges towards the axis, or away " +
        "from it in a bore. Cycle 14 names the contour before.",
      order,
      sections,
    ],
    rough,
    finish,
    notes,
  },
  861: {
    name: "Recessing, radial, simple",
    summary: "Plunges a groove with upright walls into a cylinder or a bore, from the start point to one corner.",
    description: [
      "Makes a groove in a cylinder, or in a bore, between the start point of the cycle and the corner Q493, Q494, by " +
        "plunges side by side. The start point is the first corner of the groove.",
      order,
    ],
    rough,
    finish,
    notes,
  },
  862: {
    name: "Recessing, radial, extended",
    summary: "Plunges a groove into a cylinder or a bore, with leaning walls, chamfers and floor radii.",
    description: [
      "Makes a groove in a cylinder, or in a bore, by plunges side by side. The edges can get a chamfer or a radius, " +
        "both walls can lean, and the floor corners can be rounded.",
      order,
    ],
    rough,
    finish,
    notes,
  },
  870: {
    name: "Recessing of a contour, axial",
    summary: "Plunges a contour into a face, with any number of grooves.",
    description: [
      "Takes what lies between the contour of a subprogram and the start point, by plunges along the axis. Cycle 14 " +
        "names the contour before.",
      order,
      sections,
    ],
    rough,
    finish,
    notes,
  },
  871: {
    name: "Recessing, axial, simple",
    summary: "Plunges a groove with upright walls into a face, from the start point to one corner.",
    description: [
      "Makes a groove in a face between the start point of the cycle and the corner Q493, Q494, by plunges side by " +
        "side. The start point is the first corner of the groove.",
      order,
    ],
    rough,
    finish,
    notes,
  },
  872: {
    name: "Recessing, axial, extended",
    summary: "Plunges a groove into a face, with leaning walls, chamfers and floor radii.",
    description: [
      "Makes a groove in a face by plunges side by side. The edges can get a chamfer or a radius, both walls can lean, " +
        "and the floor corners can be rounded.",
      order,
    ],
    rough,
    finish,
    notes,
  },
} satisfies CycleTexts;
