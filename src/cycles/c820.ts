import { toFlat } from "../kernel/flat.ts";
import { mirroredTool } from "../kernel/holder.ts";
import { feedsOf } from "../kernel/strategy/feeds.ts";
import { empty, planLeveled } from "../kernel/strategy/leveled.ts";
import { perSide, toRadius } from "../kernel/units.ts";
import { defineCycle, printedContour } from "./define.ts";
import { axialDepth, axialParam, choice, diameterParam, feedParam, lengthParam, oversizeDiameter } from "./params.ts";
import { frameAt, freeOutline } from "./free-outline.ts";
import { atParameters } from "./roles.ts";
import { angleIssues, withIssues } from "./tool-issues.ts";
import { contourSetups, type Setups } from "./drawn-setup.ts";

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
    Q478: feedParam("roughingFeed", [0, 99999.999], 0.3, { shown: "roughingFeed" }),
    Q483: oversizeDiameter("oversizeDiameter", [0, 99.999], 0.4, { incremental: true, shown: "oversizeDiameter" }),
    Q484: lengthParam("oversizeZ", [0, 99.999], 0.2, { incremental: true, shown: "oversizeZ" }),
    Q505: feedParam("finishingFeed", [0, 99999.999], 0.2, { shown: "finishingFeed" }),
    Q487: choice("plunging", [0, 1], 1, { shown: "plunging" }),
    Q488: feedParam("plungingFeed", [0, 99999.999], 0, { optional: true, shown: "plungingFeed" }),
    Q479: choice("limits", [0, 1], 0, { shown: "limits" }),
    Q480: diameterParam("limitDiameter", [-99999.999, 99999.999], 0, { shown: "limitDiameter" }),
    Q482: axialParam("limitZ", [-99999.999, 99999.999], 0, { shown: "limitZ" }),
    Q506: choice("smoothing", [0, 1, 2], 0, { shown: "smoothing" }),
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
  plan(v, setting, given) {
    const outline = freeOutline(v, given, true);
    if (outline.contour.length === 0 || outline.issues.length > 0) return empty(outline.issues, outline.contour);
    const frame = frameAt(outline.contour, true, setting);
    const tool = v.Q499 === 2 ? mirroredTool(setting.tool, "r") : setting.tool;
    const plan = planLeveled({
      frame,
      contour: outline.contour,
      edges: { start: 0, end: 0 },
      operation: v.Q215,
      clearance: v.Q460,
      infeed: v.Q463,
      feeds: feedsOf({ rough: v.Q478, finish: v.Q505, plunge: v.Q488 }, setting.autoFeed),
      oversize: { r: perSide(v.Q483), z: v.Q484 },
      plunging: v.Q487 === 1,
      smoothing: v.Q506,
      limit: v.Q479 === 1 ? toFlat(frame, { r: toRadius(v.Q480), z: v.Q482 }) : null,
      outerHeight: null,
      startRule: "contour",
    }, { ...setting, tool });
    const found = angleIssues(outline, tool, frame, (_q, direction) => Math.abs(direction));
    const adapted = tool === setting.tool ? plan : { ...plan, tool };
    return atParameters(withIssues(adapted, found), frame, { infeed: "Q463", limitX: "Q480", limitZ: "Q482" });
  },
});

/** Set-ups that the laws hold this cycle to. */
export const setups820: Setups = contourSetups;
