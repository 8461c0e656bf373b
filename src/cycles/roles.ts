import { toPart, type Frame } from "../kernel/geometry/flat.ts";
import type { Issue } from "../kernel/plan/issue.ts";
import { offerOf, withOffer } from "../kernel/plan/offer.ts";
import type { Plan } from "../kernel/plan/plan.ts";
import { toDiameter } from "../kernel/units.ts";

/** The Q of a cycle that plays a role of its strategy; the strategies know roles only. */
export interface Roles {
  readonly infeed: string;
  readonly depth?: string;
  readonly offset?: string;
  readonly overlap?: string;
  readonly limitX?: string;
  readonly limitZ?: string;
  /** Roles of one strategy only. */
  readonly others?: Readonly<Record<string, string>>;
}

/** A coordinate of strategy space as the program writes it: a diameter across the axis, Z along it. */
function written(frame: Frame, axis: "u" | "v", value: number): number {
  const p = toPart(frame, axis === "u" ? { u: value, v: 0 } : { u: 0, v: value });
  return isX(frame, axis) ? toDiameter(p.r) : p.z;
}
const isX = (frame: Frame, axis: "u" | "v") => (axis === "u") === frame.transverse;

function inCycle(found: Issue, frame: Frame, q: Roles): Issue {
  const axis = found.at?.endsWith("V") || found.at === "depth" ? "v" : "u";
  const at = (name: string | undefined): Issue => {
    const { at: _, ...rest } = found;
    return (name === undefined ? rest : { ...rest, at: name }) as Issue;
  };
  switch (found.at) {
    case "infeed":
      return at(q.infeed);
    case "offset":
      return at(q.offset);
    case "overlap":
      return at(q.overlap);
    case "startU":
    case "startV":
      return at(isX(frame, axis) ? "start.x" : "start.z");
    case "start":
      return at("start.x");
    case "limitU":
    case "limitV":
    case "depth":
      break;
    default:
      return found.at !== undefined && q.others?.[found.at] !== undefined ? at(q.others[found.at]) : found;
  }
  const named = at(found.at === "depth" ? q.depth : isX(frame, axis) ? q.limitX : q.limitZ);
  if (named.code !== "limitOnWrongSide") return named;
  const offer = offerOf(named);
  const limited = { ...named, data: { ...named.data, limit: written(frame, axis, named.data.limit) } };
  return offer === null ? limited : withOffer(limited, written(frame, axis, offer));
}

/** A plan with its issues at the parameters of the cycle. */
export const atParameters = (plan: Plan, frame: Frame, q: Roles): Plan => ({
  ...plan,
  issues: plan.issues.map((i) => inCycle(i, frame, q)),
  ...(plan.limits && {
    limits: plan.limits.map((l) => ({ ...l, at: (l.axis === "r" ? q.limitX : q.limitZ) ?? l.at })),
  }),
});
