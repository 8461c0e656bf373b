import { planBox } from "./box-plan.ts";
import { c812 } from "./c812.ts";
import { defineCycle } from "./define.ts";
import { angle, exampleOf, recalled } from "./params.ts";
import { plungeSetups, type Setups } from "./random-setup.ts";
import { recessOutline } from "./recess-outline.ts";
import { boxFrame, type ShoulderValues } from "./shoulder-outline.ts";

const { Q215, Q460, Q491, Q492, Q493, Q494, Q501, Q502, Q500, Q496, Q503, Q504, Q463, Q478, Q483, Q484, Q505, Q506 } =
  c812.params;

/** The contour: down a flank, along a cylinder, up a face, between an edge in front and one behind. */
const outlineOf = (v: ShoulderValues) => recessOutline(v, boxFrame(v, false));

/**
 * Plunge turning, longitudinal, extended: behind a flank, with an element at either end and corner radii on the
 * cylinder.
 */
export const c814 = defineCycle({
  number: 814,
  group: "longitudinal",
  manual: null,
  evidence: "K1",
  contour: "own",
  use: { shapes: ["plunge"] },
  params: recalled({
    Q215,
    Q460,
    Q491,
    Q492: exampleOf(Q492, -10),
    Q493,
    Q494,
    Q495: angle("plungeAngle", [0, 89.9999], 70),
    Q501,
    Q502,
    Q500,
    Q496: { ...Q496, place: "end" },
    Q503,
    Q504,
    Q463,
    Q478,
    Q483,
    Q484,
    Q505,
    Q506,
  }),
  setup: { ...c812.setup, name: "PLUNGE", tool: 2, start: { x: "79", z: "2" } },
  steps: c812.steps,
  outline: outlineOf,
  plan: (v, setting) => planBox(outlineOf(v), v, setting),
});

/** Random set-ups for the laws. */
export const setups814: Setups = /* @__PURE__ */ plungeSetups(false);
