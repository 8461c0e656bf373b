import { c820 } from "./c820.ts";
import { c851 } from "./c851.ts";
import { c852 } from "./c852.ts";
import { defineCycle } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { recalled } from "./params.ts";
import { freeRecess, planFreeRecess } from "./recess-free.ts";
import { freeRecesses } from "./recess-setups.ts";

const { Q215, Q460, Q478, Q488, Q483, Q484, Q505, Q507, Q508, Q509 } = c852.params;
const { Q479, Q480, Q482, Q499 } = c820.params;

/** Recess turning, axial: the contour of a subprogram with any number of valleys, in a face. */
export const c850 = defineCycle({
  number: 850,
  group: "recessTurning",
  manual: null,
  evidence: "K1",
  contour: "free",
  params: recalled({
    Q215,
    Q460,
    Q478,
    Q488,
    Q483,
    Q484,
    Q505,
    Q479,
    Q480,
    Q482,
    Q463: c851.params.Q463,
    Q507,
    Q508,
    Q509,
    Q499,
  }),
  setup: {
    name: "GROOVES",
    tool: 8,
    blank: { outside: "90", bore: "", length: "60", allowance: "0" },
    start: { x: "80", z: "2" },
    contour: [
      { kind: "L", x: "80", z: "0" },
      { kind: "L", z: "-6" },
      { kind: "L", x: "66" },
      { kind: "RND", r: "1.5" },
      { kind: "L", x: "64", z: "-2" },
      { kind: "L", x: "58" },
      { kind: "L", x: "55", z: "-4" },
      { kind: "RND", r: "1.5" },
      { kind: "L", x: "41" },
      { kind: "RND", r: "1.5" },
      { kind: "L", x: "38", z: "-2" },
      { kind: "L", x: "36", z: "0" },
    ],
  },
  steps: c852.steps,
  outline: (v, given) => freeRecess(v, given, true),
  plan: (v, setting, given) => planFreeRecess(v, setting, given, true),
});

/** Random set-ups for the laws. */
export const setups850: Setups = /* @__PURE__ */ freeRecesses(true);
