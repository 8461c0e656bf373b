import { c812 } from "./c812.ts";
import { c841 } from "./c841.ts";
import { c862 } from "./c862.ts";
import { defineCycle, printedContour } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { recalled } from "./params.ts";
import { simpleOutline, simpleRecess } from "./recess-plan.ts";
import { radialRecesses, simpleRecesses } from "./recess-setups.ts";
import { radialPlunges } from "./recessing-params.ts";
import { planRecessing, recessingOutline } from "./recessing-plan.ts";
import { plungedSetups } from "./recessing-setups.ts";

const { Q460 } = c812.params;
const { Q215, Q493, Q494, Q478, Q483, Q484, Q505 } = c841.params;

/** Recessing, radial, simple: a groove with upright walls from the tip at the call to a diameter and a Z. */
export const c861 = defineCycle({
  number: 861,
  group: "recessing",
  manual: null,
  evidence: "K1",
  contour: "own",
  params: recalled({ Q215, Q460, Q493, Q494, Q478, Q483, Q484, Q505, ...radialPlunges }),
  setup: {
    name: "GROOVE",
    tool: 10,
    blank: { outside: "75", bore: "", length: "80", allowance: "0" },
    start: { x: "77", z: "-20" },
    contour: printedContour,
  },
  steps: c862.steps,
  outline: (v, given) => simpleOutline(recessingOutline(simpleRecess(v, false, given), false)),
  plan(v, setting, given) {
    const whole = simpleRecess(v, false, given);
    return planRecessing(whole, simpleOutline(recessingOutline(whole, false)), setting);
  },
});

/** Random set-ups for the laws. */
export const setups861: Setups = /* @__PURE__ */ plungedSetups(/* @__PURE__ */ simpleRecesses(radialRecesses, false));
