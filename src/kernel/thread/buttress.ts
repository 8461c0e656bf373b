import { rounded } from "../units.ts";
import type { ThreadStandard } from "./standard.ts";
import { leadFacts, leadName, sizeWithLead } from "./trapezoidal.ts";

/**
 * Depth outside and inside in pitches, and the flank angles: 3° carries, 30° clears. Printed for HEIDENHAIN lathes (tag L:
 * MANUALplus 620 p. 572).
 */
const [OUTSIDE, INSIDE] = [0.86777, 0.75];
const FLANKS = [3, 30] as const;

/** Metric buttress threads. Their tables of sizes and tolerances could not be compared: every size is computed. */
export const buttress: ThreadStandard = {
  id: "buttress",
  documents: "DIN 513",
  evidence: "L",
  names: [],
  read(typed) {
    const size = sizeWithLead(leadName("s").exec(typed.size), () => undefined);
    if (!size || typed.outside || typed.inside) return null;
    const { nominal, pitch } = size;
    const flank = rounded(nominal - INSIDE * pitch);
    return {
      ...leadFacts("buttress", "S", size, typed),
      listed: false,
      angle: FLANKS[0] + FLANKS[1],
      flanks: FLANKS,
      flatRoot: true,
      outside: { crest: nominal, pitch: flank, root: rounded(nominal - 2 * OUTSIDE * pitch) },
      inside: { crest: rounded(nominal - 2 * INSIDE * pitch), pitch: flank, root: nominal },
    };
  },
};
