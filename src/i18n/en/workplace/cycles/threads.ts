import type { CycleTexts } from "../../../cycle-text.ts";
import { safePosition, turnMode } from "./notes.ts";

const steps = [
  "rapid to the clearance and to the depth of the pass",
  "cut, the feed locked to the spindle",
  "lift by the clearance at rapid",
  "back at rapid, infeed along Q467",
  "repeat until the depth is reached",
  "air cuts at the finished depth",
  "the same for the next start",
  "back to the cycle start at rapid",
];
const thread = [
  "Each pass runs from the run-in to the end of the thread, locked to the spindle; between the passes the tool " +
    "goes back at rapid. With a constant chip cross-section the depth grows with the square root of the pass.",
  "The nominal diameter is the crest of an external thread and the root of an internal one. From start Z to " +
    "end Z: that is the direction of cutting. The hand of the thread follows from it and from the direction of " +
    "the spindle. Our reading; verify on your control.",
];
const notes = [
  turnMode,
  safePosition,
  "The feed override has no effect while a thread is cut.",
  "The tool is of TYPE THREAD, and its tip points straight into the material.",
];

export const threads = {
  830: {
    name: "Thread, contour-parallel",
    summary: "Cuts a thread along a free contour.",
    description: [
      ...thread,
      "The contour is the line of the nominal diameter; it has to run on along the locked axis. Arcs are cut " +
        "as chords. Cycle 14 names it.",
    ],
    rough: steps,
    finish: [],
    notes,
  },
  831: {
    name: "Thread, longitudinal",
    summary: "Cuts a thread on a cylinder, outside or inside.",
    description: [
      ...thread,
      "The run-in is the set-up clearance Q460, the overrun is one turn of the spindle. Our reading; verify on your control.",
    ],
    rough: steps,
    finish: [],
    notes,
  },
  832: {
    name: "Thread, extended",
    summary: "Cuts a thread on a cylinder, a cone or a face, with its own run-in and overrun.",
    description: [...thread, "The taper can be given by two points or by one point and an angle (Q464)."],
    rough: steps,
    finish: [],
    notes,
  },
} satisfies CycleTexts;
