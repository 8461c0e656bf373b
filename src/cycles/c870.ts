import { c820 } from "./c820.ts";
import { c872 } from "./c872.ts";
import { defineCycle } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { recalled } from "./params.ts";
import { freeRecessing, planFreeRecessing } from "./recessing-free.ts";
import { axialPlunges } from "./recessing-params.ts";
import { freeRecesses } from "./recess-setups.ts";
import { plungedSetups } from "./recessing-setups.ts";

const { Q215, Q460, Q478, Q483, Q484, Q505 } = c872.params;
const { Q479, Q480, Q482 } = c820.params;

/** Recessing, axial: the contour of a subprogram with any number of valleys, in a face, by plunges side by side. */
export const c870 = defineCycle({
  number: 870,
  group: "recessing",
  manual: null,
  evidence: "K1",
  contour: "free",
  params: recalled({ Q215, Q460, Q478, Q483, Q484, Q505, Q479, Q480, Q482, ...axialPlunges }),
  setup: {
    name: "GROOVES",
    tool: 8,
    blank: { outside: "90", bore: "", length: "60", allowance: "0" },
    start: { x: "82", z: "2" },
    contour: [
      { kind: "L", x: "82", z: "0" },
      { kind: "L", x: "79", z: "-9" },
      { kind: "RND", r: "1.5" },
      { kind: "L", x: "62" },
      { kind: "L", x: "56", z: "-3" },
      { kind: "L", x: "48" },
      { kind: "L", x: "45", z: "-5.5" },
      { kind: "RND", r: "1.5" },
      { kind: "L", x: "27" },
      { kind: "RND", r: "1.5" },
      { kind: "L", x: "24", z: "-3" },
      { kind: "L", x: "20", z: "0" },
    ],
  },
  steps: c872.steps,
  outline: (v, given) => freeRecessing(v, given, true),
  plan: (v, setting, given) => planFreeRecessing(v, setting, given, true),
});

/** Random set-ups for the laws. */
export const setups870: Setups = /* @__PURE__ */ plungedSetups(/* @__PURE__ */ freeRecesses(true));
