import type { Expected } from "./expectation.ts";

const MILL = { T: 5, NAME: "EM10", R: 5 };
const TAP = { T: 47, NAME: "TAP10", TYPE: "TAP", R: 5, PITCH: 1.5, LCUTS: 40 };
const CORE = { T: 48, NAME: "DRILL85", TYPE: "DRILL", R: 4.25, "T-ANGLE": 140, LCUTS: 60 };
const rule = { has: { controlRule: 1 }, mostErrors: 1, tools: [MILL] };

/** Expected reports of faults in running programs: spindle and speeds, holes, the centre, rules of the control. */
export const running: Readonly<Record<string, Expected>> = {
  "plain-cut-spindle-stopped": {
    says: "a plain cut while the spindle stands, once, at the first block that meets material",
    has: { spindleStopped: 1 },
    mostErrors: 1,
    verdict: "faults",
  },
  "stopped-by-m305": { says: "a call behind M305", has: { spindleStopped: 1 }, mostErrors: 1, verdict: "faults" },
  "no-speed": { says: "a call without any speed", has: { spindleStopped: 1 }, mostErrors: 1, verdict: "faults" },
  "two-calls-spindle-stopped": {
    says: "both calls are told",
    has: { spindleStopped: 2 },
    mostErrors: 2,
    verdict: "faults",
  },
  "wrong-way-for-the-edge": {
    says: "an edge that has cut forwards does not cut backwards",
    has: { spindleStopped: 1 },
    mostErrors: 1,
    verdict: "faults",
  },
  "bar-stop-after-part-off": {
    says: "a stop that stands where a piece was cuts nothing",
    hasNot: ["spindleStopped", "cutOnLoosePiece"],
    mostErrors: 0,
    verdict: "proved",
  },
  "tap-in-solid": {
    says: "a tap where no hole is",
    has: { holeMissing: 1 },
    mostErrors: 1,
    verdict: "faults",
    tools: [TAP, CORE],
  },
  "tap-in-its-hole": {
    says: "a tap in the hole that is drilled for it",
    hasNot: ["holeMissing", "spindleStopped"],
    mostErrors: 0,
    verdict: "proved",
    tools: [TAP, CORE],
  },
  "datum-y": {
    says: "a shift in Y leaves the centre",
    has: { offCentre: 1, notProved: true },
    mostErrors: 0,
    verdict: "incomplete",
  },
  "indexed-tool": { says: "an index that the table does not have", has: { toolIndexUnknown: 1 }, mostErrors: 1 },
  "indexed-tool-there": {
    says: "an index that it has",
    hasNot: ["toolIndexUnknown", "toolUnknown"],
    mostErrors: 0,
    tools: [
      { T: 1.1, NAME: "SECOND-EDGE", TYPE: "ROUGH", TO: 1, RS: 0.8, "T-ANGLE": 95, "P-ANGLE": 80, CUTLENGTH: 12 },
    ],
  },
  "home-by-m91": {
    says: "M91 home behind the last cut leaves the proof",
    unproved: false,
    mostErrors: 0,
    verdict: "proved",
  },
  "first-element-cr": {
    says: "a contour that begins with CR",
    has: { firstElement: 1 },
    mostErrors: 1,
    verdict: "faults",
  },
  "first-element-ct": {
    says: "a contour that begins with CT",
    has: { firstElement: 1 },
    mostErrors: 1,
    verdict: "faults",
  },
  "rule-ipa-sign": { says: "IPA and DR of unlike sign", ...rule },
  "rule-rnd-zero-behind": { says: "an element of length 0 behind RND", ...rule },
  "rule-cc-empty-one-axis": { says: "an empty CC behind a block with one axis", ...rule },
  "rule-rl-on-arc": { says: "RL that begins on an arc", ...rule },
  "rule-tool-call-under-rl": { says: "TOOL CALL under RL", ...rule },
  "functions-that-move-nothing": {
    says: "AFC, LIFTOFF and their like leave the proof",
    unproved: false,
    mostErrors: 0,
    verdict: "proved",
  },
  "face-without-smax": { says: "facing to the axis without SMAX", has: { speedUnlimited: 1 }, mostErrors: 0 },
  "face-with-smax": { says: "the same with SMAX", hasNot: ["speedUnlimited", "speedUnlikely"], mostErrors: 0 },
  "shoulder-without-smax": {
    says: "without SMAX far from the axis",
    hasNot: ["speedUnlimited"],
    mostErrors: 0,
    verdict: "proved",
  },
  "surface-speed-unlikely": {
    says: "a surface speed that no material allows",
    has: { speedUnlikely: 1 },
    mostErrors: 0,
  },
  "face-groove-small": {
    says: "a blade along Z whose range is not stated",
    holder: "unknown",
    mostErrors: 0,
    verdict: "proved",
  },
  "groove-far-across-axis": {
    says: "a groove that is stated many metres across the axis has a floor everywhere",
    hasNot: ["tooManyPasses"],
    mostErrors: 0,
    verdict: "proved",
  },
  "inch-offer": {
    says: "a limit in inch, and no other size for a chamfer",
    errorAt: ["Q502"],
    offers: [],
    limits: [0.75],
  },
};
