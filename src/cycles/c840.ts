import { c820 } from "./c820.ts";
import { c842 } from "./c842.ts";
import { defineCycle } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { choice, recalled } from "./params.ts";
import { freeRecess, planFreeRecess } from "./recess-free.ts";
import { freeRecesses } from "./recess-setups.ts";

const { Q215, Q460, Q478, Q488, Q483, Q484, Q505, Q463, Q507, Q508, Q509 } = c842.params;
const { Q479, Q480, Q482 } = c820.params;

/** Recess turning, radial: the contour of a subprogram with any number of valleys, in a cylinder or in a bore. */
export const c840 = defineCycle({
  number: 840,
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
    Q463,
    Q507,
    Q508,
    Q509,
    Q499: choice("reverseAlong", [0, 1, 2], 0, { shown: "reverse" }),
  }),
  setup: {
    name: "GROOVES",
    tool: 9,
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
      { kind: "L", x: "60", z: "-41" },
      { kind: "RND", r: "3" },
      { kind: "L", z: "-55" },
      { kind: "RND", r: "3" },
      { kind: "L", x: "68", z: "-58" },
      { kind: "L", z: "-62" },
      { kind: "L", x: "75", z: "-65" },
    ],
  },
  steps: c842.steps,
  outline: (v, given) => freeRecess(v, given, false),
  plan: (v, setting, given) => planFreeRecess(v, setting, given, false),
});

/** Random set-ups for the laws. */
export const setups840: Setups = /* @__PURE__ */ freeRecesses(false);
