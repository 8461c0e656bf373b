import { length } from "../kernel/units.ts";
import { defineCycle } from "./define.ts";
import { axialDepth, axialParam, choice, diameterParam, feedParam, lengthParam, oversizeDiameter } from "./params.ts";

/** Free contour of a subprogram, cut across the axis. */
export const c820 = defineCycle({
  number: 820,
  group: "contour",
  manual: { section: "14.17", document: "TNC 640, cycle programming, 10/2019; ranges: TNC7" },
  evidence: "A",
  contour: "free",
  params: {
    Q215: choice("operation", [0, 1, 2, 3], 0),
    Q460: lengthParam("clearance", [0, 999.999], 2, { incremental: true }),
    Q499: choice("reverseContour", [0, 1, 2], 0),
    Q463: axialDepth("infeedAxial", [0, 99.999], 3),
    Q478: feedParam("roughingFeed", [0, 99999.999], 0.3),
    Q483: oversizeDiameter("oversizeDiameter", [0, 99.999], 0.4, { incremental: true }),
    Q484: lengthParam("oversizeZ", [0, 99.999], 0.2, { incremental: true }),
    Q505: feedParam("finishingFeed", [0, 99999.999], 0.2),
    Q487: choice("plunging", [0, 1], 1),
    Q488: feedParam("plungingFeed", [0, 99999.999], 0, { optional: true }),
    Q479: choice("limits", [0, 1], 0),
    Q480: diameterParam("limitDiameter", [-99999.999, 99999.999], 0),
    Q482: axialParam("limitZ", [-99999.999, 99999.999], 0),
    Q506: choice("smoothing", [0, 1, 2], 0),
  },
  steps: { rough: 6, finish: 4 },
  outline: () => ({ contour: [], dimensions: [], issues: [] }),
  plan: () => ({ moves: [], issues: [], contour: [], passes: 0, infeed: length(0), area: [], part: [], reach: [] }),
});
