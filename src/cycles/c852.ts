import { defineCycle, printedContour } from "./define.ts";
import type { Setups } from "./random-setup.ts";
import {
  angle,
  axialDepth,
  axialParam,
  choice,
  diameterParam,
  feedParam,
  whenFinishing,
  lengthParam,
  oversizeDiameter,
  whenRoughing,
} from "./params.ts";
import { finishedRecess, planRecessTurning } from "./recess-plan.ts";
import { axialRecesses } from "./recess-setups.ts";

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
    Q215: choice("operation", [0, 1, 2, 3], 0, { shown: "operation" }),
    Q460: lengthParam("clearanceReserved", [0, 999.999], 2, {
      incremental: true,
      rangeEvidence: "I",
      reserved: true,
      shown: "clearance",
    }),
    Q491: diameterParam("startDiameter", [-99999.999, 99999.999], 75, { rangeEvidence: "K2" }),
    Q492: axialParam("startZ", [-99999.999, 99999.999], -20, { rangeEvidence: "K2" }),
    Q493: diameterParam("endDiameter", [-99999.999, 99999.999], 50, { rangeEvidence: "K2", place: "end" }),
    Q494: axialParam("endZ", [-99999.999, 99999.999], -50, { rangeEvidence: "K2", place: "end" }),
    Q495: angle("flankAngle", [0, 89.9999], 5, { rangeEvidence: "K2" }),
    Q501: choice("startElement", [0, 1, 2], 1, { shown: "element" }),
    Q502: lengthParam("startElementSize", [0, 999.999], 0.5, { rangeEvidence: "K2", sizes: "Q501" }),
    Q500: lengthParam("cornerRadius", [0, 999.999], 1.5, { rangeEvidence: "K2", optional: true, rounds: true }),
    Q496: angle("secondFlankAngle", [0, 89.9999], 5, { rangeEvidence: "K2", place: "end" }),
    Q503: choice("endElement", [0, 1, 2], 1, { shown: "element", place: "end" }),
    Q504: lengthParam("endElementSize", [0, 999.999], 0.5, { rangeEvidence: "K2", place: "end", sizes: "Q503" }),
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
    Q463: axialDepth("infeedGroove", [0.001, 999.999], 2, { shown: "infeed" }),
    Q507: choice("direction", [0, 1], 0, { shown: "direction", counts: whenRoughing }),
    Q508: lengthParam("offsetWidth", [0, 99.999], 0, {
      rangeEvidence: "K2",
      shown: "offsetWidth",
      counts: whenRoughing,
    }),
    Q509: axialParam("depthCompensation", [-9.9999, 9.9999], 0, {
      rangeEvidence: "K2",
      incremental: true,
      decimals: 4,
      shown: "depthCompensation",
    }),
    Q488: feedParam("plungingFeed", [0, 99999.999], 0, {
      optional: true,
      rangeEvidence: "I",
      shown: "plungingFeed",
      counts: whenRoughing,
      filledIn: 0,
    }),
  },
  // The printed groove is 20 mm behind Z0 and its tool is 35 mm long, so the face of this blank is at the start of the
  // groove.
  setup: {
    name: "GROOVE",
    tool: 8,
    blank: { outside: "90", bore: "", length: "60", allowance: "-20" },
    start: { x: "75", z: "2" },
    contour: printedContour,
  },
  steps: { rough: 8, finish: 7 },
  outline: (v) => finishedRecess(v, true),
  plan: (v, setting) => planRecessTurning(v, finishedRecess(v, true), setting),
});

/** Random set-ups for the laws. */
export const setups852: Setups = axialRecesses;
