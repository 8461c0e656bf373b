import { c820 } from "./c820.ts";
import { c840 } from "./c840.ts";
import { c862 } from "./c862.ts";
import { defineCycle } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { recalled } from "./params.ts";
import { freeRecessing, planFreeRecessing } from "./recessing-free.ts";
import { radialPlunges } from "./recessing-params.ts";
import { freeRecesses } from "./recess-setups.ts";
import { plungedSetups } from "./recessing-setups.ts";

const { Q215, Q460, Q478, Q483, Q484, Q505 } = c862.params;
const { Q479, Q480, Q482 } = c820.params;

/**
 * Recessing, radial: the contour of a subprogram with any number of valleys, in a cylinder or in a bore, by plunges
 * side by side.
 */
export const c860 = defineCycle({
  number: 860,
  group: "recessing",
  manual: null,
  evidence: "K1",
  contour: "free",
  params: recalled({ Q215, Q460, Q478, Q483, Q484, Q505, Q479, Q480, Q482, ...radialPlunges }),
  setup: { ...c840.setup, tool: 10 },
  steps: c862.steps,
  outline: (v, given) => freeRecessing(v, given, false),
  plan: (v, setting, given) => planFreeRecessing(v, setting, given, false),
});

/** Random set-ups for the laws. */
export const setups860: Setups = /* @__PURE__ */ plungedSetups(/* @__PURE__ */ freeRecesses(false));
