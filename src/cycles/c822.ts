import { planBox } from "./box-plan.ts";
import { c812 } from "./c812.ts";
import { c820 } from "./c820.ts";
import { defineCycle } from "./define.ts";
import { exampleOf, recalled } from "./params.ts";
import { faceSetups, type Setups } from "./random-setup.ts";
import { shoulderOutline } from "./shoulder-outline.ts";

const { Q215, Q460, Q491, Q492, Q493, Q494, Q501, Q502, Q500, Q503, Q504, Q478, Q483, Q484, Q505, Q506 } = c812.params;
const { Q495: surfaceAngle, Q496: faceAngle } = c812.params;

/** Shoulder, transverse, extended: face, inner corner, circumferential surface, with an element at either end. */
export const c822 = defineCycle({
  number: 822,
  group: "transverse",
  manual: null,
  evidence: "K1",
  contour: "own",
  params: recalled({
    Q215,
    Q460,
    Q491,
    Q492,
    Q493: exampleOf(Q493, 30),
    Q494: exampleOf(Q494, -15),
    Q495: exampleOf(faceAngle, 0),
    Q501,
    Q502,
    Q500,
    Q496: exampleOf(surfaceAngle, 5),
    Q503,
    Q504,
    Q463: c820.params.Q463,
    Q478,
    Q483,
    Q484,
    Q505,
    Q506,
  }),
  setup: { ...c812.setup, tool: 15, start: { x: "79", z: "0" } },
  steps: c812.steps,
  outline: (v) => shoulderOutline(v, true),
  plan: (v, setting) => planBox(shoulderOutline(v, true), v, setting),
});

/** Random set-ups for the laws. */
export const setups822: Setups = faceSetups;
