import { planBox } from "./box-plan.ts";
import { c814 } from "./c814.ts";
import { defineCycle } from "./define.ts";
import { recalled } from "./params.ts";
import { plungeSetups, type Setups, withoutCornerElements } from "./random-setup.ts";
import { recessOutline } from "./recess-outline.ts";
import { boxFrame, PLAIN, type ShoulderValues } from "./shoulder-outline.ts";

const { Q215, Q460, Q491, Q492, Q493, Q494, Q495, Q463, Q478, Q483, Q484, Q505, Q506 } = c814.params;

/** Adds the values of the extended cycle, with nothing at the corners. */
const whole = <V extends Omit<ShoulderValues, keyof typeof PLAIN>>(v: V) => ({ ...v, ...PLAIN });

/** Plunge turning, longitudinal: behind a flank, along a cylinder, to a square face. */
export const c813 = defineCycle({
  number: 813,
  group: "longitudinal",
  manual: null,
  evidence: "K1",
  contour: "own",
  use: { shapes: ["plunge"] },
  params: recalled({ Q215, Q460, Q491, Q492, Q493, Q494, Q495, Q463, Q478, Q483, Q484, Q505, Q506 }),
  setup: c814.setup,
  steps: c814.steps,
  outline: (v) => recessOutline(whole(v), boxFrame(v, false)),
  plan: (v, setting) => planBox(recessOutline(whole(v), boxFrame(v, false)), whole(v), setting),
});

/** Random set-ups for the laws. */
export const setups813: Setups = /* @__PURE__ */ withoutCornerElements(/* @__PURE__ */ plungeSetups(false));
