import { mirroredTool } from "../kernel/cutter/holder.ts";
import { feedsOf } from "../kernel/strategy/feeds.ts";
import { planContourParallel } from "../kernel/strategy/contour-parallel.ts";
import { emptyPlan } from "../kernel/strategy/leveled.ts";
import { axial, perSide, radius, toDiameter } from "../kernel/units.ts";
import { c812 } from "./c812.ts";
import { c820 } from "./c820.ts";
import { partlyPrinted } from "./partly-printed.ts";
import { defineCycle, type Given } from "./define.ts";
import { allowanceSetups } from "./allowance-setups.ts";
import type { Setups } from "./random-setup.ts";
import { frameAt, freeOutline } from "./free-outline.ts";
import { choice, lengthParam, radial, recalled, whenRoughing } from "./params.ts";
import { atParameters } from "./roles.ts";
import { angleIssues, withIssues } from "./tool-issues.ts";

const { Q215, Q460, Q478, Q483, Q484, Q505 } = c812.params;
const { Q499 } = c820.params;

/** The contour in machining direction; this cycle has no limits. */
const outlineOf = (v: { readonly Q499: number }, given: Given) =>
  freeOutline({ Q499: v.Q499, Q479: 0, Q480: toDiameter(radius(0)), Q482: axial(0) }, given, false);

/** Free contour of a subprogram, cut by passes that run parallel to it, as on a casting or a forging. */
export const c815 = defineCycle({
  number: 815,
  group: "longitudinal",
  manual: null,
  partly: { section: "Cycle 815", document: "TNC7, 81762x-17", parts: ["name", "start", "roughing", "firstFinishing"] },
  evidence: "K1",
  contour: "free",
  use: { shapes: ["step", "plunge", "free"], preTurned: true },
  params: partlyPrinted(
    recalled({
      Q215,
      Q460,
      Q485: lengthParam("blankAllowance", [0, 99.999], 5, { incremental: true, shown: "allowance" }),
      Q486: choice("cuttingLines", [0, 1], 0, { shown: "cuttingLines", counts: whenRoughing }),
      Q499,
      Q463: radial("infeedParallel", [0, 99.999], 3, { shown: "infeed" }),
      Q478,
      Q483,
      Q484,
      Q505,
    }),
    { Q463: "meaning", Q478: "meaning" },
  ),
  setup: {
    name: "PARALLEL",
    tool: 2,
    blank: { outside: "60", bore: "", length: "80", allowance: "0" },
    start: { x: "66", z: "4" },
    contour: [
      { kind: "L", x: "50.5", z: "0" },
      { kind: "L", z: "-14" },
      { kind: "CR", x: "56", z: "-26", r: "24", turn: "cw" },
      { kind: "L", z: "-38" },
      { kind: "RND", r: "3" },
      { kind: "L", x: "51", z: "-46" },
      { kind: "RND", r: "4" },
      { kind: "L", z: "-58" },
    ],
  },
  steps: { rough: 6, finish: 4 },
  outline: outlineOf,
  plan(v, setting, given) {
    const outline = outlineOf(v, given);
    if (outline.contour.length === 0 || outline.issues.length > 0) return emptyPlan(outline.issues, outline.contour);
    const frame = frameAt(outline.contour, false, setting);
    const tool = v.Q499 === 2 ? mirroredTool(setting.tool, "z") : setting.tool;
    const plan = planContourParallel(
      {
        frame,
        contour: outline.contour,
        operation: v.Q215,
        clearance: v.Q460,
        allowance: v.Q485,
        sameArea: v.Q486 === 0,
        infeed: v.Q463,
        feeds: feedsOf({ rough: v.Q478, finish: v.Q505 }, setting.autoFeed),
        oversize: { r: perSide(v.Q483), z: v.Q484 },
      },
      { ...setting, tool },
    );
    const found = angleIssues(outline, tool, frame, (_q, direction) => Math.abs(direction));
    const adapted = tool === setting.tool ? plan : { ...plan, tool };
    return atParameters(withIssues(adapted, found), frame, { infeed: "Q463" });
  },
});

/** Random set-ups for the laws. */
export const setups815: Setups = allowanceSetups;
