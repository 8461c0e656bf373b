import { c820 } from "./c820.ts";
import { c862 } from "./c862.ts";
import { defineCycle } from "./define.ts";
import type { Setups } from "./drawn-setup.ts";
import { recalled } from "./params.ts";
import { freeRecessing, planFreeRecessing } from "./recessing-free.ts";
import { radialPlunges } from "./recessing-params.ts";
import { freeRecesses } from "./recess-setups.ts";
import { plungedSetups } from "./recessing-setups.ts";

const { Q215, Q460, Q478, Q483, Q484, Q505 } = c862.params;
const { Q479, Q480, Q482 } = c820.params;

/** Recessing, radial: the contour of a subprogram with any number of valleys, in a cylinder or in a bore, by plunges side by side. */
export const c860 = defineCycle({
  number: 860,
  group: "recessing",
  manual: null,
  evidence: "K1",
  contour: "free",
  params: recalled({ Q215, Q460, Q478, Q483, Q484, Q505, Q479, Q480, Q482, ...radialPlunges }),
  setup: {
    name: "GROOVES",
    tool: 10,
    blank: { outside: "75", bore: "", length: "90", allowance: "0" },
    start: { x: "77", z: "-15" },
    contour: [
      { kind: "L", x: "75", z: "-15" },
      { kind: "L", x: "58", z: "-16.5" },
      { kind: "RND", r: "2" },
      { kind: "L", z: "-30" },
      { kind: "RND", r: "2" },
      { kind: "L", x: "68", z: "-31.5" },
      { kind: "L", z: "-38" },
      { kind: "CR", z: "-58", r: "13", turn: "cw" },
      { kind: "L", z: "-62" },
      { kind: "L", x: "75", z: "-65" },
    ],
  },
  steps: c862.steps,
  outline: (v, given) => freeRecessing(v, given, false),
  plan: (v, setting, given) => planFreeRecessing(v, setting, given, false),
});

/** Set-ups that the laws hold this cycle to. */
export const setups860: Setups = plungedSetups(freeRecesses(false));
