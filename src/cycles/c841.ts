import { c842 } from "./c842.ts";
import { defineCycle, printedContour } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { recalled } from "./params.ts";
import { finishedRecess, planRecessTurning, simpleOutline, simpleRecess } from "./recess-plan.ts";
import { radialRecesses, simpleRecesses } from "./recess-setups.ts";

const { Q215, Q460, Q493, Q494, Q478, Q483, Q484, Q505, Q463, Q507, Q508, Q509, Q488 } = c842.params;

/** Recess turning, radial, simple: a groove with upright walls from the tip at the call to a diameter and a Z. */
export const c841 = defineCycle({
  number: 841,
  group: "recessTurning",
  manual: null,
  evidence: "K1",
  contour: "own",
  params: recalled({ Q215, Q460, Q493, Q494, Q478, Q483, Q484, Q505, Q463, Q507, Q508, Q509, Q488 }),
  setup: {
    name: "GROOVE",
    tool: 9,
    blank: { outside: "75", bore: "", length: "80", allowance: "0" },
    start: { x: "77", z: "-20" },
    contour: printedContour,
  },
  steps: c842.steps,
  outline: (v, given) => simpleOutline(finishedRecess(simpleRecess(v, false, given), false)),
  plan(v, setting, given) {
    const whole = simpleRecess(v, false, given);
    return planRecessTurning(whole, simpleOutline(finishedRecess(whole, false)), setting);
  },
});

/** Random set-ups for the laws. */
export const setups841: Setups = /* @__PURE__ */ simpleRecesses(radialRecesses, false);
