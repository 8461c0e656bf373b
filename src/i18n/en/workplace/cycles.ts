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
    B: "printed for a related control",
    L: "taken from the lathe controls that these cycles come from",
    I: "derived from printed facts",
    K1: "not verified against a manual, high confidence",
    K2: "not verified against a manual, medium confidence",
    K3: "not verified against a manual, low confidence",
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
