import { c812 } from "./c812.ts";
import { c852 } from "./c852.ts";
import { defineCycle, printedContour } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { recalled } from "./params.ts";
import { axialRecesses } from "./recess-setups.ts";
import { axialPlunges } from "./recessing-params.ts";
import { planRecessing, recessingOutline } from "./recessing-plan.ts";
import { plungedSetups } from "./recessing-setups.ts";

const { Q460 } = c812.params;
const { Q215, Q491, Q492, Q493, Q494, Q495, Q501, Q502, Q500, Q496, Q503, Q504, Q478, Q483, Q484, Q505 } = c852.params;

/** Recessing, axial, extended: a groove in a face by plunges side by side. */
export const c872 = defineCycle({
  number: 872,
  group: "recessing",
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
    Q495,
    Q501,
    Q502,
    Q500,
    Q496,
    Q503,
    Q504,
    Q478,
    Q483,
    Q484,
    Q505,
    ...axialPlunges,
  }),
  setup: {
    name: "GROOVE",
    tool: 8,
    blank: { outside: "90", bore: "", length: "60", allowance: "-20" },
    start: { x: "75", z: "2" },
    contour: printedContour,
  },
  steps: { rough: 6, finish: 8 },
  outline: (v) => recessingOutline(v, true),
  plan: (v, setting) => planRecessing(v, recessingOutline(v, true), setting),
});

/** Random set-ups for the laws. */
export const setups872: Setups = /* @__PURE__ */ plungedSetups(axialRecesses);
