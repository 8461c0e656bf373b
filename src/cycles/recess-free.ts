import { toFlat, type Frame } from "../kernel/geometry/flat.ts";
import { mirroredTool } from "../kernel/cutter/holder.ts";
import type { Plan, PlanContext } from "../kernel/plan/plan.ts";
import { at, part, type Segment } from "../kernel/geometry/point.ts";
import { feedsOf } from "../kernel/strategy/feeds.ts";
import { planRecess } from "../kernel/strategy/recess.ts";
import { perSide, toRadius } from "../kernel/units.ts";
import type { Given, Outline } from "./define.ts";
import { freeOutline, plungeFrame, type FreeValues } from "./free-outline.ts";
import type { TurnedRecess } from "./recess-plan.ts";
import { refusedPlan } from "./refused-plan.ts";
import { atParameters } from "./roles.ts";
import { angleIssues, withIssues } from "./tool-issues.ts";

/** The values for turning the recesses of a programmed contour. */
type FreeRecess = FreeValues & TurnedRecess;

/**
 * The programmed contour in machining direction; the tool goes in from its open side, and the part continues past both
 * ends.
 */
export function freeRecess(v: FreeRecess, given: Given, transverse: boolean): Outline {
  const outline = freeOutline(v, given, transverse);
  return { ...outline, sunk: true, contour: shifted(outline.contour, outline.frame, v.Q509) };
}

/**
 * A programmed contour has several floors: Q509 shifts all of it, positive out of the material (decision "Sections of a
 * recess").
 */
function shifted(contour: readonly Segment[], { transverse, signV }: Frame, by: number): readonly Segment[] {
  const offset = transverse ? at(signV * by, 0) : at(0, signV * by);
  return by === 0 ? contour : contour.map((s) => part.shifted(s, offset));
}

/** Plans the recesses of a programmed contour, in a cylinder or in a face. */
export function planFreeRecess(v: FreeRecess, setting: PlanContext, given: Given, transverse: boolean): Plan {
  const outline = freeOutline(v, given, transverse);
  const none = refusedPlan(outline);
  if (none) return none;
  const frame = plungeFrame(outline.contour, transverse, setting);
  const tool = v.Q499 === 2 ? mirroredTool(setting.tool, transverse ? "r" : "z") : setting.tool;
  const plan = planRecess(
    {
      frame,
      contour: shifted(outline.contour, frame, v.Q509),
      operation: v.Q215,
      infeed: v.Q463,
      feeds: feedsOf({ rough: v.Q478, finish: v.Q505, plunge: v.Q488 }, setting.autoFeed),
      oversize: { r: perSide(v.Q483), z: v.Q484 },
      oneWay: v.Q507 === 1,
      offset: v.Q508,
      downwards: "steep",
      free: true,
      limit: v.Q479 === 1 ? toFlat(frame, { r: toRadius(v.Q480), z: v.Q482 }) : null,
    },
    { ...setting, tool },
  );
  const found = angleIssues(outline, tool, frame, (_q, direction) => Math.abs(direction));
  const adapted = tool === setting.tool ? plan : { ...plan, tool };
  return atParameters(withIssues(adapted, found), frame, {
    infeed: "Q463",
    offset: "Q508",
    limitX: "Q480",
    limitZ: "Q482",
  });
}
