import type { Frame } from "../kernel/flat.ts";
import { cuttingWidth, isBar } from "../kernel/insert.ts";
import { issue, type Issue } from "../kernel/issue.ts";
import { feedsOf } from "../kernel/strategy/feeds.ts";
import { planRecess } from "../kernel/strategy/recess.ts";
import { axial, type Axial, type Diameter, perSide, radius, rounded, toDiameter } from "../kernel/units.ts";
import { defineCycle, printedContour } from "./define.ts";
import { angle, axialDepth, axialParam, choice, diameterParam, feedParam, lengthParam, oversizeDiameter } from "./params.ts";
import { recessOutline, type RecessOutline } from "./recess-outline.ts";
import { atParameters } from "./roles.ts";
import { boxFrame } from "./shoulder-outline.ts";
import { refused } from "./refused.ts";
import { angleIssues, cornerIssue, withIssues } from "./tool-issues.ts";
import { ROUND } from "../kernel/tolerance.ts";
import { recessSetups, type Setups } from "./drawn-setup.ts";

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
    Q460: lengthParam("clearanceReserved", [0, 999.999], 2, { incremental: true, rangeEvidence: "I", reserved: true, shown: "clearance" }),
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
    Q478: feedParam("roughingFeed", [0, 99999.999], 0.3, { rangeEvidence: "I", shown: "roughingFeed" }),
    Q483: oversizeDiameter("oversizeDiameter", [0, 99.999], 0.4, { incremental: true, shown: "oversizeDiameter" }),
    Q484: lengthParam("oversizeZ", [0, 99.999], 0.2, { incremental: true, rangeEvidence: "I", shown: "oversizeZ" }),
    Q505: feedParam("finishingFeed", [0, 99999.999], 0.2, { rangeEvidence: "I", shown: "finishingFeed" }),
    Q463: axialDepth("infeedGroove", [0.001, 999.999], 2, { shown: "infeed" }),
    Q507: choice("direction", [0, 1], 0, { shown: "direction" }),
    Q508: lengthParam("offsetWidth", [0, 99.999], 0, { rangeEvidence: "K2", shown: "offsetWidth" }),
    Q509: axialParam("depthCompensation", [-9.9999, 9.9999], 0, {
      rangeEvidence: "K2",
      incremental: true,
      decimals: 4,
      shown: "depthCompensation",
    }),
    Q488: feedParam("plungingFeed", [0, 99999.999], 0, { optional: true, rangeEvidence: "I", shown: "plungingFeed" }),
  },
  // The groove is printed 20 mm behind Z0, and its tool is 35 mm long: the face of this blank stands where the groove starts.
  setup: {
    name: "GROOVE",
    tool: 8,
    blank: { outside: "90", bore: "", length: "60", allowance: "-20" },
    start: { x: "75", z: "2" },
    contour: printedContour,
  },
  steps: { rough: 8, finish: 7 },
  outline: (v) => recessOutline(finished(v), frameOf(v)),
  plan(v, setting) {
    const outline = recessOutline(finished(v), frameOf(v));
    const none = refused(outline);
    if (none) return none;
    const { frame } = outline;
    const { tool } = setting;
    const plan = planRecess({
      frame,
      contour: outline.contour,
      operation: v.Q215,
      infeed: v.Q463,
      feeds: feedsOf({ rough: v.Q478, finish: v.Q505, plunge: v.Q488 }, setting.autoFeed),
      oversize: { r: perSide(v.Q483), z: v.Q484 },
      oneWay: v.Q507 === 1,
      offset: v.Q508,
      roundedFloor: v.Q500 > 0,
    }, setting);
    const rough = v.Q215 !== 2;
    const narrow = narrowIssue(outline, v, isBar(tool) ? cuttingWidth(tool) + (rough ? v.Q483 : 0) : 0);
    const found = [...narrow, ...cornerIssue(v.Q500, tool), ...angleIssues(outline, tool, frame, outline.angleAt)];
    return atParameters(withIssues(plan, found), frame, { infeed: "Q463", depth: "Q494", offset: "Q508" });
  },
});

type Ends = { readonly Q491: Diameter; readonly Q492: Axial; readonly Q493: Diameter; readonly Q494: Axial };

const frameOf = (v: Ends): Frame => boxFrame(v, true);

/**
 * The values with the floor where Q509 shifts it, positive out of the material: that is the finished groove (decision "Recess
 * turning").
 */
const finished = <
  V extends Ends & { readonly Q509: Axial },
>(v: V): V => (v.Q509 === 0 ? v : { ...v, Q494: axial(v.Q494 + frameOf(v).signV * v.Q509) });

/** A tool that is wider than the floor (with the oversize on both walls) cannot reach it; wider than the opening, not at all. */
function narrowIssue(outline: RecessOutline, v: { Q491: Diameter; Q493: Diameter }, tool: number): Issue[] {
  if (tool <= outline.floor + ROUND) return [];
  const missing = toDiameter(radius(tool - outline.floor));
  const nearest = rounded(v.Q493 + Math.sign(v.Q493 - v.Q491) * missing);
  return [issue("recessNarrowerThanTool", tool > outline.opening ? "error" : "warning", { width: outline.floor, tool, nearest }, "Q493")];
}

/** Set-ups that the laws hold this cycle to. */
export const setups852: Setups = recessSetups;
