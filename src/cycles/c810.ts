import { c820 } from "./c820.ts";
import { defineCycle, type Row } from "./define.ts";
import { radial, recalled } from "./params.ts";
import { freeOutline } from "./free-outline.ts";
import { planFree } from "./free-plan.ts";
import { contourSetups, type Setups } from "./random-setup.ts";

const { Q215, Q460, Q499, Q478, Q483, Q484, Q505, Q487, Q488, Q479, Q480, Q482, Q506 } = c820.params;

/** Our own example, a shaft: a chamfer, a neck between two cylinders, and a shoulder. */
const shaft: readonly Row[] = [
  { kind: "L", x: "28", z: "0" },
  { kind: "L", x: "30", z: "-1" },
  { kind: "L", z: "-20" },
  { kind: "L", x: "24", z: "-28" },
  { kind: "L", z: "-38" },
  { kind: "RND", r: "2" },
  { kind: "L", x: "42", z: "-44" },
  { kind: "L", z: "-55" },
  { kind: "RND", r: "1.5" },
  { kind: "L", x: "60" },
];

/** Free contour of a subprogram, cut along the axis. */
export const c810 = defineCycle({
  number: 810,
  group: "longitudinal",
  manual: null,
  evidence: "K1",
  contour: "free",
  params: recalled({
    Q215,
    Q460,
    Q499,
    Q463: radial("infeedContour", [0, 99.999], 3, { shown: "infeed" }),
    Q478,
    Q483,
    Q484,
    Q505,
    Q487,
    Q488,
    Q479,
    Q480,
    Q482,
    Q506,
  }),
  setup: {
    name: "SHAFT",
    tool: 2,
    blank: { outside: "60", bore: "", length: "100", allowance: "0" },
    start: { x: "60", z: "2" },
    contour: shaft,
  },
  steps: c820.steps,
  outline: (v, given) => freeOutline(v, given, false),
  plan: (v, setting, given) => planFree(v, setting, given, false),
});

/** Random set-ups for the laws. */
export const setups810: Setups = /* @__PURE__ */ contourSetups(false);
