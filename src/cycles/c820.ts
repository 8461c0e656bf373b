import { defineCycle, printedContour } from "./define.ts";
import {
  axialDepth,
  axialParam,
  choice,
  diameterParam,
  feedParam,
  whenFinishing,
  lengthParam,
  whenLimited,
  oversizeDiameter,
  whenRoughing,
} from "./params.ts";
import { freeOutline } from "./free-outline.ts";
import { planFree } from "./free-plan.ts";
import { contourSetups, type Setups } from "./random-setup.ts";

/** Free contour of a subprogram, cut across the axis. */
export const c820 = defineCycle({
  number: 820,
  group: "transverse",
  manual: { section: "14.17", document: "TNC 640, cycle programming, 10/2019; ranges: TNC7" },
  evidence: "A",
  contour: "free",
  params: {
    Q215: choice("operation", [0, 1, 2, 3], 0, { shown: "operation" }),
    Q460: lengthParam("clearance", [0, 999.999], 2, { incremental: true, shown: "clearance" }),
    Q499: choice("reverseContour", [0, 1, 2], 0, { shown: "reverse" }),
    Q463: axialDepth("infeedAxial", [0, 99.999], 3, { shown: "infeed" }),
    Q478: feedParam("roughingFeed", [0, 99999.999], 0.3, { shown: "roughingFeed", counts: whenRoughing }),
    Q483: oversizeDiameter("oversizeDiameter", [0, 99.999], 0.4, { incremental: true, shown: "oversizeDiameter" }),
    Q484: lengthParam("oversizeZ", [0, 99.999], 0.2, { incremental: true, shown: "oversizeZ" }),
    Q505: feedParam("finishingFeed", [0, 99999.999], 0.2, { shown: "finishingFeed", counts: whenFinishing }),
    Q487: choice("plunging", [0, 1], 1, { shown: "plunging" }),
    Q488: feedParam("plungingFeed", [0, 99999.999], 0, { optional: true, shown: "plungingFeed", counts: whenRoughing }),
    Q479: choice("limits", [0, 1], 0, { shown: "limits" }),
    Q480: diameterParam("limitDiameter", [-99999.999, 99999.999], 0, { shown: "limitDiameter", counts: whenLimited }),
    Q482: axialParam("limitZ", [-99999.999, 99999.999], 0, { shown: "limitZ", counts: whenLimited }),
    Q506: choice("smoothing", [0, 1, 2], 0, { shown: "smoothing", counts: whenRoughing }),
  },
  setup: {
    name: "CONTOUR",
    tool: 15,
    blank: { outside: "75", bore: "", length: "80", allowance: "0" },
    start: { x: "75", z: "2" },
    contour: printedContour,
  },
  steps: { rough: 6, finish: 4 },
  outline: (v, given) => freeOutline(v, given, true),
  plan: (v, setting, given) => planFree(v, setting, given, true),
});

/** Random set-ups for the laws. */
export const setups820: Setups = /* @__PURE__ */ contourSetups(true);
