import { c811 } from "./c811.ts";
import { c822 } from "./c822.ts";
import { defineCycle } from "./define.ts";
import { exampleOf, recalled } from "./params.ts";
import { faceSetups, simpleSetups, type Setups } from "./random-setup.ts";
import { planSimple, simpleShoulder } from "./simple-shoulder.ts";

const { Q215, Q460, Q493, Q494, Q463, Q478, Q483, Q484, Q505, Q506 } = c822.params;

/** Shoulder, transverse: a face and a cylinder, from the tip at the call. */
export const c821 = defineCycle({
  number: 821,
  group: "transverse",
  manual: null,
  evidence: "K1",
  contour: "own",
  params: recalled({
    Q215,
    Q460,
    Q493: exampleOf(Q493, 30),
    Q494: exampleOf(Q494, -5),
    Q463,
    Q478,
    Q483,
    Q484,
    Q505,
    Q506,
  }),
  setup: { ...c822.setup },
  steps: c811.steps,
  outline: (v, { start }) => simpleShoulder(v, start, true),
  plan: (v, setting) => planSimple(v, setting, true),
});

/** Random set-ups for the laws. */
export const setups821: Setups = /* @__PURE__ */ simpleSetups(faceSetups);
