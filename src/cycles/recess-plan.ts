import type { Frame } from "../kernel/geometry/flat.ts";
import { cuttingWidth, isBar } from "../kernel/cutter/insert.ts";
import { issue, type Issue } from "../kernel/plan/issue.ts";
import type { Plan, PlanContext } from "../kernel/plan/plan.ts";
import { part, type Pt } from "../kernel/geometry/point.ts";
import { feedsOf } from "../kernel/strategy/feeds.ts";
import { planRecess } from "../kernel/strategy/recess.ts";
import { SAME } from "../kernel/tolerance.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import {
  axial,
  degrees,
  type Diameter,
  type Feed,
  length,
  perSide,
  radius,
  roundedDown,
  toDiameter,
  toRadius,
} from "../kernel/units.ts";
import type { Given } from "./define.ts";
import { recessOutline, type RecessOutline } from "./recess-outline.ts";
import { refusedPlan } from "./refused-plan.ts";
import { atParameters, type Roles } from "./roles.ts";
import { boxFrame, type ShoulderValues } from "./shoulder-outline.ts";
import { angleIssues, cornerIssue, withIssues } from "./tool-issues.ts";

/** The ends of a recess. */
type Ends = Pick<ShoulderValues, "Q491" | "Q492" | "Q493" | "Q494">;
type Shifted = { readonly Q509: number };

/**
 * The finished recess, its floor shifted by Q509, positive out of the material (decision "Recess turning"): along Z in
 * a face, on the radius in a cylinder.
 */
export function finishedRecess(v: ShoulderValues & Shifted, transverse: boolean): RecessOutline {
  const frame = boxFrame(v, transverse);
  const by = frame.signV * v.Q509;
  if (by === 0) return recessOutline(v, frame);
  const floor = transverse ? { Q494: axial(v.Q494 + by) } : { Q493: toDiameter(radius(toRadius(v.Q493) + by)) };
  return recessOutline({ ...v, ...floor }, frame);
}

/** The values for turning a recess, whatever its contour. */
export interface TurnedRecess extends Shifted {
  readonly Q215: number;
  readonly Q478: Feed | "auto";
  readonly Q483: Diameter;
  readonly Q484: number;
  readonly Q505: Feed | "auto";
  readonly Q463: number;
  readonly Q507: number;
  readonly Q508: number;
  readonly Q488: Feed | "auto";
}
/** The operation on a recess, and its oversizes. */
type Worked = Pick<TurnedRecess, "Q215" | "Q483" | "Q484">;
/** The values of a recess between two walls. */
type RecessTurning = ShoulderValues & TurnedRecess;

/** The path of a recess-turning cycle with its own contour; `outline` is the finished recess. */
export function planRecessTurning(v: RecessTurning, outline: RecessOutline, setting: PlanContext): Plan {
  const none = refusedPlan(outline);
  if (none) return none;
  const { frame } = outline;
  const { tool } = setting;
  const oversize = { r: perSide(v.Q483), z: v.Q484 };
  const plan = planRecess(
    {
      frame,
      contour: outline.contour,
      operation: v.Q215,
      infeed: v.Q463,
      feeds: feedsOf({ rough: v.Q478, finish: v.Q505, plunge: v.Q488 }, setting.autoFeed),
      oversize,
      oneWay: v.Q507 === 1,
      offset: v.Q508,
      downwards: v.Q500 > 0 ? "none" : "every",
      free: false,
      limit: null,
    },
    setting,
  );
  const found = [
    ...narrowIssue(outline, v, tool),
    ...cornerIssue(v.Q500, tool),
    ...angleIssues(outline, tool, frame, outline.angleAt),
  ];
  return atParameters(withIssues(plan, found), frame, rolesIn(frame));
}

const rolesIn = (frame: Frame): Roles => ({
  infeed: "Q463",
  depth: frame.transverse ? "Q494" : "Q493",
  offset: "Q508",
});

/**
 * A bar wider than the floor, with the oversize on both walls, cannot reach it; one wider than the opening cannot
 * enter. Where the bar alone fits, less oversize is enough; otherwise the recess needs a narrower tool, since its width
 * is that of the drawing.
 */
export function narrowIssue({ frame, floor, opening }: RecessOutline, v: Worked, tool: Tool): Issue[] {
  if (!isBar(tool)) return [];
  const [width, oversize] = [cuttingWidth(tool), frame.transverse ? v.Q483 : 2 * v.Q484];
  const needed = width + (v.Q215 === 2 ? 0 : oversize);
  if (needed <= floor + SAME) return [];
  const room = Math.max(0, floor - width);
  const [at, most] = frame.transverse ? ["Q483", room] : ["Q484", room / 2];
  const fits = width <= floor + SAME;
  const data = { width: floor, tool: needed, ...(fits && { nearest: roundedDown(most) }) };
  return [issue("recessNarrowerThanTool", needed > opening + SAME ? "error" : "warning", data, fits ? at : "tool")];
}

/** Assumed opening of a simple recess while the start point is unknown: width and depth, mm. */
const ASSUMED = { wide: 30, deep: 12.5 };

/**
 * The first corner of a simple recess: the tip at the call; while that is unknown, one that makes an outside groove.
 */
function firstCorner(v: Pick<Ends, "Q493" | "Q494">, transverse: boolean, { start }: Given): Pt {
  const [z, r] = transverse ? [ASSUMED.deep, ASSUMED.deep] : [ASSUMED.wide, ASSUMED.deep];
  return start ?? part.point(v.Q494 + z, toRadius(v.Q493) + r);
}

/** The extended values of a simple recess: from the tip at the call, with upright walls, and nothing at its corners. */
export function simpleRecess<V extends Pick<Ends, "Q493" | "Q494">>(
  v: V,
  transverse: boolean,
  given: Given,
): V & ShoulderValues {
  const first = firstCorner(v, transverse, given);
  const none = length(0);
  return {
    ...v,
    Q491: toDiameter(radius(first.r)),
    Q492: axial(first.z),
    Q495: degrees(0),
    Q501: 0,
    Q502: none,
    Q500: none,
    Q496: degrees(0),
    Q503: 0,
    Q504: none,
  };
}

/** The outline of a simple recess reports at its own two parameters; issues of the others belong to the start point. */
export function simpleOutline(outline: RecessOutline): RecessOutline {
  const { transverse } = outline.frame;
  const own: Readonly<Record<string, string>> = {
    Q491: "start.x",
    Q492: "start.z",
    Q495: transverse ? "start.x" : "start.z",
    Q496: transverse ? "Q493" : "Q494",
  };
  const named = (q: string) => own[q] ?? q;
  return {
    ...outline,
    names: outline.names.map(named),
    dimensions: outline.dimensions.filter((d) => d.q === "Q493" || d.q === "Q494"),
    issues: outline.issues.map((i): Issue =>
      i.code === "startEqualsEnd"
        ? { ...i, data: { ...i.data, other: i.data.other === "Q491" ? "X" : "Z" } }
        : { ...i, ...(i.at !== undefined && { at: named(i.at) }) },
    ),
  };
}
