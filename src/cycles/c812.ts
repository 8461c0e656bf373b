import { planBox } from "./box-plan.ts";
import { defineCycle, printedContour } from "./define.ts";
import {
  angle,
  axialParam,
  choice,
  diameterParam,
  feedParam,
  whenFinishing,
  lengthParam,
  oversizeDiameter,
  radial,
  whenRoughing,
} from "./params.ts";
import { shoulderOutline } from "./shoulder-outline.ts";
import { shoulderSetups, type Setups } from "./random-setup.ts";

/** Shoulder, longitudinal, extended: circumferential surface, inner corner, face, with an element at either end. */
export const c812 = defineCycle({
  number: 812,
  group: "longitudinal",
  manual: { section: "14.8", document: "TNC 640, cycle programming, 10/2019" },
  evidence: "A",
  contour: "own",
  params: {
    Q215: choice("operation", [0, 1, 2, 3], 0, { shown: "operation" }),
    Q460: lengthParam("clearance", [0, 999.999], 2, { incremental: true, rangeEvidence: "I", shown: "clearance" }),
    Q491: diameterParam("startDiameter", [-99999.999, 99999.999], 75, { rangeEvidence: "K2" }),
    Q492: axialParam("startZ", [-99999.999, 99999.999], 0, { rangeEvidence: "K2" }),
    Q493: diameterParam("endDiameter", [-99999.999, 99999.999], 50, { rangeEvidence: "K2", place: "end" }),
    Q494: axialParam("endZ", [-99999.999, 99999.999], -55, { rangeEvidence: "K2", place: "end" }),
    Q495: angle("surfaceAngle", [0, 89.9999], 5, { rangeEvidence: "K2" }),
    Q501: choice("startElement", [0, 1, 2], 1, { shown: "element" }),
    Q502: lengthParam("startElementSize", [0, 999.999], 0.5, { rangeEvidence: "K2", sizes: "Q501" }),
    Q500: lengthParam("cornerRadius", [0, 999.999], 1.5, { rangeEvidence: "K2", optional: true, rounds: true }),
    Q496: angle("faceAngle", [0, 89.9999], 0, { rangeEvidence: "K2" }),
    Q503: choice("endElement", [0, 1, 2], 1, { shown: "element", place: "end" }),
    Q504: lengthParam("endElementSize", [0, 999.999], 0.5, { rangeEvidence: "K2", place: "end", sizes: "Q503" }),
    Q463: radial("infeedRadial", [0.001, 999.999], 3, { shown: "infeed" }),
    Q478: feedParam("roughingFeed", [0, 99999.999], 0.3, {
      rangeEvidence: "I",
      shown: "roughingFeed",
      counts: whenRoughing,
    }),
    Q483: oversizeDiameter("oversizeDiameter", [0, 99.999], 0.4, { incremental: true, shown: "oversizeDiameter" }),
    Q484: lengthParam("oversizeZ", [0, 99.999], 0.2, { incremental: true, rangeEvidence: "I", shown: "oversizeZ" }),
    Q505: feedParam("finishingFeed", [0, 99999.999], 0.2, {
      rangeEvidence: "I",
      shown: "finishingFeed",
      counts: whenFinishing,
    }),
    Q506: choice("smoothing", [0, 1, 2], 0, { shown: "smoothing", counts: whenRoughing }),
  },
  setup: {
    name: "SHOULDER",
    tool: 1,
    blank: { outside: "75", bore: "", length: "100", allowance: "0" },
    start: { x: "75", z: "2" },
    contour: printedContour,
  },
  steps: { rough: 6, finish: 4 },
  outline: (v) => shoulderOutline(v, false),
  plan: (v, setting) => planBox(shoulderOutline(v, false), v, setting),
});

/** Random set-ups for the laws. */
export const setups812: Setups = shoulderSetups;
