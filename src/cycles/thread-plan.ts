import type { Frame } from "../kernel/geometry/flat.ts";
import type { Plan, PlanContext } from "../kernel/plan/plan.ts";
import type { Segment } from "../kernel/geometry/point.ts";
import { planThread } from "../kernel/strategy/thread.ts";
import type { Degrees, Length, Radius } from "../kernel/units.ts";
import { atParameters, type Roles } from "./roles.ts";
import type { ThreadValues } from "./thread-outline.ts";

/** The values of every thread cycle. */
interface Threading extends ThreadValues {
  readonly Q460: Length;
  readonly Q463: Radius;
  readonly Q468: number;
  readonly Q470: Degrees;
  readonly Q476: number;
}

const ROLES: Roles = {
  infeed: "Q463",
  others: {
    pitch: "Q472",
    threadDepth: "Q473",
    runOut: "Q474",
    infeedAngle: "Q467",
    runIn: "Q465",
    overrun: "Q466",
    crest: "Q491",
  },
};

/**
 * Plans a thread along a line; the cycle states the kind of line, the lengths of run-in and overrun, and the prompts
 * for the roles.
 */
export function planThreadOn(
  v: Threading,
  line: { readonly contour: readonly Segment[]; readonly frame: Frame },
  ways: { readonly runIn: number; readonly overrun: number; readonly named?: Readonly<Record<string, string>> },
  setting: PlanContext,
): Plan {
  // A face is open on the side from which the tip points into it.
  const behind = line.frame.transverse && [3, 4, 5].includes(setting.tool.TO);
  const frame: Frame = behind ? { ...line.frame, signV: -1 } : line.frame;
  const plan = planThread(
    {
      frame,
      contour: line.contour,
      inside: v.Q471 === 1,
      lead: v.Q472,
      starts: v.Q475,
      depth: v.Q473,
      runIn: ways.runIn,
      overrun: ways.overrun,
      runOut: v.Q474,
      infeed: v.Q463,
      flankAngle: v.Q467,
      constantDepth: v.Q468 === 1,
      startAngle: v.Q470,
      airCuts: v.Q476,
      clearance: v.Q460,
    },
    setting,
  );
  return atParameters(plan, frame, { ...ROLES, others: { ...ROLES.others, ...ways.named } });
}
