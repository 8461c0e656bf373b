import type { CycleTexts } from "../../../cycle-text.ts";
import { safePosition, turnMode } from "./notes.ts";

const steps = [
  "to the set-up clearance and the depth of the pass at rapid traverse",
  "cut with the feed synchronized to the spindle",
  "lift off by the set-up clearance at rapid traverse",
  "return at rapid traverse, infeed along Q467",
  "repeat until the depth is reached",
  "air cuts at the finished depth",
  "the same for the next start",
  "return to the cycle start at rapid traverse",
];
const thread = [
  "Each pass runs from the run-in to the end of the thread, synchronized to the spindle; between passes the tool " +
    "returns at rapid traverse. With a constant chip cross-section the depth grows with the square root of the " +
    "pass number.",
  "The nominal diameter is the crest of an external thread and the root of an internal one. The thread is cut " +
    "from start Z to end Z. This direction and the spindle direction determine whether the thread is right-hand or " +
    "left-hand.",
];
const notes = [
  turnMode,
  safePosition,
  "The feed override has no effect during thread cutting.",
  "The tool has TYPE THREAD, and its tip points perpendicularly into the material.",
];

export const threads = {
  830: {
    name: "Thread, contour-parallel",
    summary: "Cuts a thread along a free contour.",
    description: [
      ...thread,
      "The contour is the line of the nominal diameter; it must run in one direction along the synchronized " +
        "axis. Arcs are cut as chords. Cycle 14 selects the contour.",
    ],
    rough: steps,
    finish: [],
    notes,
  },
  831: {
    name: "Thread, longitudinal",
    summary: "Cuts a thread on a cylinder, outside or inside.",
    description: [...thread, "The run-in is the set-up clearance Q460, the overrun is one spindle revolution."],
    rough: steps,
    finish: [],
    notes,
  },
  832: {
    name: "Thread, extended",
    summary: "Cuts a thread on a cylinder, a cone or a face, with separate run-in and overrun.",
    description: [...thread, "The taper can be given by two points or by one point and an angle (Q464)."],
    rough: steps,
    finish: [],
    notes,
  },
} satisfies CycleTexts;
