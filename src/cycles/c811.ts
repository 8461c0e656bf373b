import { c812 } from "./c812.ts";
import { defineCycle } from "./define.ts";
import { recalled } from "./params.ts";
import { shoulderSetups, simpleSetups, type Setups } from "./random-setup.ts";
import { planSimple, simpleShoulder } from "./simple-shoulder.ts";

const { Q215, Q460, Q493, Q494, Q463, Q478, Q483, Q484, Q505, Q506 } = c812.params;

/** Shoulder, longitudinal: a cylinder and a face, from the tip at the call. */
export const c811 = defineCycle({
  number: 811,
  group: "longitudinal",
  manual: null,
  evidence: "K1",
  contour: "own",
  params: recalled({ Q215, Q460, Q493, Q494, Q463, Q478, Q483, Q484, Q505, Q506 }),
  setup: { ...c812.setup },
  steps: c812.steps,
  outline: (v, { start }) => simpleShoulder(v, start, false),
  plan: (v, setting) => planSimple(v, setting, false),
});

/** Random set-ups for the laws. */
export const setups811: Setups = /* @__PURE__ */ simpleSetups(shoulderSetups);
