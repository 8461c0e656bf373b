import { c852 } from "./c852.ts";
import { defineCycle, printedContour } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { angle, radial, recalled } from "./params.ts";
import { finishedRecess, planRecessTurning } from "./recess-plan.ts";
import { radialRecesses } from "./recess-setups.ts";

const { Q215, Q460, Q491, Q492, Q493, Q494, Q501, Q502, Q500, Q503, Q504, Q478, Q483, Q484, Q505, Q507, Q508, Q488 } =
  c852.params;

/**
 * Recess turning, radial, extended: a groove in a cylinder or in a bore; the wall angles count from the perpendicular
 * to the axis.
 */
export const c842 = defineCycle({
  number: 842,
  group: "recessTurning",
  manual: null,
  evidence: "K1",
  contour: "own",
  params: recalled({
    Q215,
    Q460,
    Q491,
    Q492,
    Q493,
    Q494,
    Q495: angle("flankAngleRadial", [0, 89.9999], 5),
    Q501,
    Q502,
    Q500,
    Q496: angle("secondFlankAngleRadial", [0, 89.9999], 5, { place: "end" }),
    Q503,
    Q504,
    Q478,
    Q483,
    Q484,
    Q505,
    Q463: radial("infeedRadial", [0.001, 999.999], 2, { shown: "infeed" }),
    Q507,
    Q508,
    Q509: radial("depthCompensation", [-9.9999, 9.9999], 0, {
      incremental: true,
      decimals: 4,
      shown: "depthCompensation",
    }),
    Q488,
  }),
  setup: {
    name: "GROOVE",
    tool: 9,
    blank: { outside: "75", bore: "", length: "80", allowance: "0" },
    start: { x: "79", z: "-20" },
    contour: printedContour,
  },
  steps: c852.steps,
  outline: (v) => finishedRecess(v, false),
  plan: (v, setting) => planRecessTurning(v, finishedRecess(v, false), setting),
});

/** Random set-ups for the laws. */
export const setups842: Setups = radialRecesses;
