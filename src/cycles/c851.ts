import { c852 } from "./c852.ts";
import { defineCycle, printedContour } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { axialDepth, exampleOf, recalled } from "./params.ts";
import { finishedRecess, planRecessTurning, simpleOutline, simpleRecess } from "./recess-plan.ts";
import { axialRecesses, simpleRecesses } from "./recess-setups.ts";

const { Q215, Q460, Q493, Q494, Q478, Q483, Q484, Q505, Q507, Q508, Q509, Q488 } = c852.params;

/**
 * Recess turning, axial, simple: a groove in a face with upright walls from the tip at the call to a diameter and a Z.
 */
export const c851 = defineCycle({
  number: 851,
  group: "recessTurning",
  manual: null,
  evidence: "K1",
  contour: "own",
  params: recalled({
    Q215,
    Q460,
    Q493,
    Q494: exampleOf(Q494, -10),
    Q478,
    Q483,
    Q484,
    Q505,
    Q463: axialDepth("infeedFace", [0.001, 999.999], 2, { shown: "infeed" }),
    Q507,
    Q508,
    Q509,
    Q488,
  }),
  setup: {
    name: "GROOVE",
    tool: 8,
    blank: { outside: "90", bore: "", length: "60", allowance: "0" },
    start: { x: "75", z: "1" },
    contour: printedContour,
  },
  steps: c852.steps,
  outline: (v, given) => simpleOutline(finishedRecess(simpleRecess(v, true, given), true)),
  plan(v, setting, given) {
    const whole = simpleRecess(v, true, given);
    return planRecessTurning(whole, simpleOutline(finishedRecess(whole, true)), setting);
  },
});

/** Random set-ups for the laws. */
export const setups851: Setups = /* @__PURE__ */ simpleRecesses(axialRecesses, true);
