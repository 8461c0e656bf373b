import type { CyclesTexts } from "../../cycle-text.ts";
import { longitudinal } from "./cycles/longitudinal.ts";
import { transverse } from "./cycles/transverse.ts";
import { recessTurning } from "./cycles/recess-turning.ts";
import { recessing } from "./cycles/recessing.ts";
import { threads } from "./cycles/threads.ts";
import { special } from "./cycles/special.ts";

export const cycles = {
  groups: {
    special: "Special",
    longitudinal: "Longitudinal turning",
    transverse: "Transverse turning",
    recessTurning: "Recess turning",
    recessing: "Recessing",
    thread: "Threads",
  },
  evidence: {
    A: "printed in a manual page of this control",
    B: "printed for a sister control",
    L: "taken from the lathe controls these cycles come from",
    I: "inferred from printed facts",
    K1: "clearly recalled, not checked against a printed page",
    K2: "recalled, not checked against a printed page",
    K3: "uncertain, not checked against a printed page",
  },
  kinds: {
    choice: "choice",
    diameter: "diameter",
    oversizeDiameter: "oversize on the diameter",
    radial: "on the radius",
    axial: "along Z",
    axialDepth: "depth along Z",
    length: "length",
    angle: "angle",
    feed: "feed",
    count: "number of times",
    factor: "factor",
    percent: "percent",
    revolutions: "revolutions",
  },
  roughStep: (step, of, text) => `Step ${step} of ${of}: ${text}`,
  finishStep: (step, of, text) => `Finishing, step ${step} of ${of}: ${text}`,
  positioning: "Positioning before step 1",
  kept: { 880: "Gear hobbing", 882: "Simultaneous roughing", 883: "Simultaneous finishing", 892: "Check unbalance" },
  of: { ...special, ...longitudinal, ...transverse, ...recessTurning, ...recessing, ...threads },
} satisfies CyclesTexts;
