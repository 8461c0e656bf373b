import { c812 } from "./c812.ts";
import { c851 } from "./c851.ts";
import { c872 } from "./c872.ts";
import { defineCycle, printedContour } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { recalled } from "./params.ts";
import { simpleOutline, simpleRecess } from "./recess-plan.ts";
import { axialRecesses, simpleRecesses } from "./recess-setups.ts";
import { axialPlunges } from "./recessing-params.ts";
import { planRecessing, recessingOutline } from "./recessing-plan.ts";
import { plungedSetups } from "./recessing-setups.ts";

const { Q460 } = c812.params;
const { Q215, Q493, Q494, Q478, Q483, Q484, Q505 } = c851.params;

/** Recessing, axial, simple: a groove with upright walls from the tip at the call to a Z and a diameter. */
export const c871 = defineCycle({
  number: 871,
  group: "recessing",
  manual: null,
  evidence: "K1",
  contour: "own",
  params: recalled({ Q215, Q460, Q493, Q494, Q478, Q483, Q484, Q505, ...axialPlunges }),
  setup: {
    name: "GROOVE",
    tool: 8,
    blank: { outside: "90", bore: "", length: "60", allowance: "0" },
    start: { x: "75", z: "1" },
    contour: printedContour,
  },
  steps: c872.steps,
  outline: (v, given) => simpleOutline(recessingOutline(simpleRecess(v, true, given), true)),
  plan(v, setting, given) {
    const whole = simpleRecess(v, true, given);
    return planRecessing(whole, simpleOutline(recessingOutline(whole, true)), setting);
  },
});

/** Random set-ups for the laws. */
export const setups871: Setups = /* @__PURE__ */ plungedSetups(/* @__PURE__ */ simpleRecesses(axialRecesses, true));
