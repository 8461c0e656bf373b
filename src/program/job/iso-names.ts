import { cycleByNumber } from "../../cycles/index.ts";
import type { IsoNames } from "../../nc/iso/names.ts";
import type { Labels } from "./print-job.ts";

/** Names and labels for converting a DIN/ISO program to Klartext: those of the catalogue in one label language. */
export const isoNames = (labels: Labels): IsoNames => ({
  cycle: (cycle) => (cycleByNumber(cycle) ? labels.cycleName(cycle) : ""),
  label: (cycle, q) => {
    const param = cycleByNumber(cycle)?.params[q];
    return param ? labels.label(param.text) : null;
  },
  contour: labels.contour,
});
