import type { ThreadRoles } from "./define.ts";
import { angle, axialParam, choice, countParam, diameterParam, lengthParam, radial } from "./params.ts";

const ON_DIAMETER = [-99999.999, 99999.999] as const;

/**
 * The parameters of the thread cycles, with the values of the recalled examples; each cycle takes them in its own
 * order.
 */
export const threadParams = {
  Q471: choice("threadPosition", [0, 1], 0, { shown: "threadPosition" }),
  Q461: choice("threadOrientation", [0, 1], 0, { shown: "threadOrientation" }),
  Q460: lengthParam("clearance", [0, 999.999], 2, { incremental: true, shown: "clearance" }),
  Q472: lengthParam("threadPitch", [0, 99999.999], 2, { shown: "pitch" }),
  Q473: lengthParam("threadDepth", [0, 999.999], 0, { incremental: true, shown: "threadDepth" }),
  Q464: choice("taperForm", [0, 1, 2, 3, 4], 0, { shown: "taperForm" }),
  Q491: diameterParam("threadStartDiameter", ON_DIAMETER, 100),
  Q492: axialParam("startZ", ON_DIAMETER, 0),
  Q493: diameterParam("threadEndDiameter", ON_DIAMETER, 110, { place: "end" }),
  Q494: axialParam("endZ", ON_DIAMETER, -35, { place: "end" }),
  Q469: angle("taperAngle", [-180, 180], 0, { counts: { q: "Q464", among: [1, 2, 3, 4] } }),
  Q474: lengthParam("threadRunOut", [0, 999.999], 0, { place: "end" }),
  Q465: lengthParam("threadRunIn", [0.1, 99.9], 4, { incremental: true, shown: "runIn" }),
  Q466: lengthParam("threadOverrun", [0.1, 99.9], 4, { incremental: true, place: "end", drawn: false }),
  Q463: radial("firstInfeed", [0.001, 999.999], 0.5, { shown: "infeed" }),
  Q467: angle("infeedAngle", [0, 60], 30, { drawn: false }),
  Q468: choice("infeedType", [0, 1], 0, { shown: "infeedType" }),
  Q470: angle("startingAngle", [0, 359.999], 0, { shown: "startingAngle" }),
  Q475: countParam("threadStarts", [1, 500], 30, { shown: "threadStarts" }),
  Q476: countParam("airCuts", [0, 255], 30, { shown: "airCuts" }),
};

/** The parameters that a nominal size fills; `diameters` where the cycle has any. */
export const threadRoles = (...diameters: readonly string[]): ThreadRoles => ({
  position: "Q471",
  pitch: "Q472",
  depth: "Q473",
  starts: "Q475",
  flank: "Q467",
  diameters,
});

/**
 * The recalled example has 30 grooves and 30 air cuts: a pitch of 0.067 mm, and half an hour without anything to see.
 */
export const oneGroove = { Q475: 1, Q476: 1 } as const;
