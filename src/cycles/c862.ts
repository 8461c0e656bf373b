import { c812 } from "./c812.ts";
import { c842 } from "./c842.ts";
import { defineCycle, printedContour } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import { recalled } from "./params.ts";
import { radialRecesses } from "./recess-setups.ts";
import { radialPlunges } from "./recessing-params.ts";
import { planRecessing, recessingOutline } from "./recessing-plan.ts";
import { plungedSetups } from "./recessing-setups.ts";

const { Q460 } = c812.params;
const { Q215, Q491, Q492, Q493, Q494, Q495, Q501, Q502, Q500, Q496, Q503, Q504, Q478, Q483, Q484, Q505 } = c842.params;

/** Recessing, radial, extended: a groove in a cylinder or in a bore by plunges side by side. */
export const c862 = defineCycle({
  number: 862,
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
    ...radialPlunges,
  }),
  setup: {
    name: "GROOVE",
    tool: 10,
    blank: { outside: "75", bore: "", length: "80", allowance: "0" },
    start: { x: "79", z: "-20" },
    contour: printedContour,
  },
  steps: { rough: 6, finish: 8 },
  outline: (v) => recessingOutline(v, false),
  plan: (v, setting) => planRecessing(v, recessingOutline(v, false), setting),
});

/** Random set-ups for the laws. */
export const setups862: Setups = /* @__PURE__ */ plungedSetups(radialRecesses);
