import { planBox } from "./box-plan.ts";
import { c824 } from "./c824.ts";
import { defineCycle } from "./define.ts";
import { exampleOf, recalled } from "./params.ts";
import { plungeSetups, type Setups, withoutCornerElements } from "./random-setup.ts";
import { recessOutline } from "./recess-outline.ts";
import { boxFrame, PLAIN, type ShoulderValues } from "./shoulder-outline.ts";

const { Q215, Q460, Q491, Q492, Q493, Q494, Q495, Q463, Q478, Q483, Q484, Q505, Q506 } = c824.params;

/** Adds the values of the extended cycle, with nothing at the corners. */
const whole = <V extends Omit<ShoulderValues, keyof typeof PLAIN>>(v: V) => ({ ...v, ...PLAIN });

/** Plunge turning, transverse: behind a flank, across a floor, to a square wall. */
export const c823 = defineCycle({
  number: 823,
  group: "transverse",
  manual: null,
  evidence: "K1",
  contour: "own",
  use: { shapes: ["plunge"] },
  params: recalled({
    Q215,
    Q460,
    Q491,
    Q492,
    Q493,
    Q494: exampleOf(Q494, -5),
    Q495: exampleOf(Q495, 60),
    Q463,
    Q478,
    Q483,
    Q484,
    Q505,
    Q506,
  }),
  setup: c824.setup,
  steps: c824.steps,
  outline: (v) => recessOutline(whole(v), boxFrame(v, true)),
  plan: (v, setting) => planBox(recessOutline(whole(v), boxFrame(v, true)), whole(v), setting),
});

/** Random set-ups for the laws. */
export const setups823: Setups = /* @__PURE__ */ withoutCornerElements(/* @__PURE__ */ plungeSetups(true));
