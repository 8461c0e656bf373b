import { planBox } from "./box-plan.ts";
import { c814 } from "./c814.ts";
import { c822 } from "./c822.ts";
import { defineCycle } from "./define.ts";
import { angle, exampleOf, recalled } from "./params.ts";
import { plungeSetups, type Setups } from "./random-setup.ts";
import { recessOutline } from "./recess-outline.ts";
import { boxFrame, type ShoulderValues } from "./shoulder-outline.ts";

const { Q215, Q460, Q491, Q492, Q493, Q494, Q501, Q502, Q500, Q496, Q503, Q504, Q463, Q478, Q483, Q484, Q505, Q506 } =
  c822.params;

/** The contour: down a flank, across a floor, up a wall, between an edge in front and one behind. */
const outlineOf = (v: ShoulderValues) => recessOutline(v, boxFrame(v, true));

/**
 * Plunge turning, transverse, extended: behind a flank, with an element at either end and corner radii on the floor.
 */
export const c824 = defineCycle({
  number: 824,
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
    Q493: exampleOf(Q493, 20),
    Q494: exampleOf(Q494, -10),
    Q495: angle("plungeAngleFace", [0, 89.9999], 70),
    Q501,
    Q502,
    Q500,
    Q496: { ...exampleOf(Q496, 0), place: "end" },
    Q503,
    Q504,
    Q463,
    Q478,
    Q483,
    Q484,
    Q505,
    Q506,
  }),
  // In the recalled example the flank runs down nearly to the end: a floor of 0.025 mm has no room for two corner
  // radii.
  setup: { ...c814.setup, tool: 15, values: { Q495: 60 } },
  steps: c814.steps,
  outline: outlineOf,
  plan: (v, setting) => planBox(outlineOf(v), v, setting),
});

/** Random set-ups for the laws. */
export const setups824: Setups = /* @__PURE__ */ plungeSetups(true);
