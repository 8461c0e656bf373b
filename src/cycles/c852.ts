import { length } from "../kernel/units.ts";
import { defineCycle } from "./define.ts";
import {
  angle, axialDepth, axialParam, choice, diameterParam, feedParam, lengthParam, oversizeDiameter,
} from "./params.ts";

/**
 * Recess turning, axial, extended: a groove in a face with two walls, a floor, and an element at either edge.
 * The page prints Q463 as radial; the infeed of an axial groove runs along Z, so it is an axial depth here.
 */
export const c852 = defineCycle({
  number: 852,
  group: "recessTurning",
  manual: { section: "14.21", document: "TNC 640, cycle programming, 10/2019", page: 515 },
  evidence: "A",
  contour: "own",
  params: {
    Q215: choice("operation", [0, 1, 2, 3], 0),
    Q460: lengthParam("clearanceReserved", [0, 999.999], 2, { incremental: true, rangeEvidence: "I", reserved: true }),
    Q491: diameterParam("startDiameter", [-99999.999, 99999.999], 75, { rangeEvidence: "K2" }),
    Q492: axialParam("startZ", [-99999.999, 99999.999], -20, { rangeEvidence: "K2" }),
    Q493: diameterParam("endDiameter", [-99999.999, 99999.999], 50, { rangeEvidence: "K2" }),
    Q494: axialParam("endZ", [-99999.999, 99999.999], -50, { rangeEvidence: "K2" }),
    Q495: angle("flankAngle", [0, 89.9999], 5, { rangeEvidence: "K2" }),
    Q501: choice("startElement", [0, 1, 2], 1),
    Q502: lengthParam("startElementSize", [0, 999.999], 0.5, { rangeEvidence: "K2" }),
    Q500: lengthParam("cornerRadius", [0, 999.999], 1.5, { rangeEvidence: "K2", optional: true }),
    Q496: angle("secondFlankAngle", [0, 89.9999], 5, { rangeEvidence: "K2" }),
    Q503: choice("endElement", [0, 1, 2], 1),
    Q504: lengthParam("endElementSize", [0, 999.999], 0.5, { rangeEvidence: "K2" }),
    Q478: feedParam("roughingFeed", [0, 99999.999], 0.3, { rangeEvidence: "I" }),
    Q483: oversizeDiameter("oversizeDiameter", [0, 99.999], 0.4, { incremental: true }),
    Q484: lengthParam("oversizeZ", [0, 99.999], 0.2, { incremental: true, rangeEvidence: "I" }),
    Q505: feedParam("finishingFeed", [0, 99999.999], 0.2, { rangeEvidence: "I" }),
    Q463: axialDepth("infeedGroove", [0.001, 999.999], 2),
    Q507: choice("direction", [0, 1], 0),
    Q508: lengthParam("offsetWidth", [0, 99.999], 0, { rangeEvidence: "K2" }),
    Q509: axialParam("depthCompensation", [-9.9999, 9.9999], 0, { rangeEvidence: "K2", incremental: true, decimals: 4 }),
    Q488: feedParam("plungingFeed", [0, 99999.999], 0, { optional: true, rangeEvidence: "I" }),
  },
  steps: { rough: 8, finish: 7 },
  outline: () => ({ contour: [], dimensions: [], issues: [] }),
  plan: () => ({ moves: [], issues: [], contour: [], passes: 0, infeed: length(0), area: [], part: [], reach: [] }),
});
