import { toPart, type Flat, type FlatSegment, type Frame } from "../geometry/flat.ts";
import { issue, type Issue } from "../plan/issue.ts";
import type { MachiningLimit, Plan } from "../plan/plan.ts";

/** The area that machining limits leave: a range of u, and of heights. */
export interface Limits {
  readonly from: number;
  readonly to: number;
  readonly floor: number | null;
  readonly ceiling: number;
}

const NONE: Limits = { from: -Infinity, to: Infinity, floor: null, ceiling: Infinity };

/**
 * The tool position at the call decides which side of each limit is machined; the other is not cut (decision "Limits").
 */
export function limitsOf(limit: Flat | null, called: Flat, contour: readonly FlatSegment[], issues: Issue[]): Limits {
  if (!limit) return NONE;
  const before = called.u <= limit.u;
  const above = called.v >= limit.v;
  const us = contour.flatMap((s) => [s.from.u, s.to.u]);
  const vs = contour.flatMap((s) => [s.from.v, s.to.v]);
  const wrong = (value: number, nearest: number, at: string) =>
    issues.push(issue("limitOnWrongSide", "warning", { limit: value, nearest }, at));
  if (before ? limit.u <= Math.min(...us) : limit.u >= Math.max(...us))
    wrong(limit.u, before ? Math.max(...us) : Math.min(...us), "limitU");
  if (above ? limit.v >= Math.max(...vs) : limit.v <= Math.min(...vs))
    wrong(limit.v, above ? Math.min(...vs) : Math.max(...vs), "limitV");
  return {
    from: before ? -Infinity : limit.u,
    to: before ? limit.u : Infinity,
    floor: above ? limit.v : null,
    ceiling: above ? Infinity : limit.v,
  };
}

/** The same limits in part space, for the check of the cuts; empty if a plan has none. */
export function limitsInPart(limit: Flat | null, called: Flat, frame: Frame): Pick<Plan, "limits"> {
  if (!limit) return {};
  const of = (axis: "u" | "v", at: string, behind: 1 | -1): MachiningLimit => {
    const [point, beyond] = [limit, { ...limit, [axis]: limit[axis] + behind }].map((p) => toPart(frame, p));
    const along = (axis === "u") === frame.transverse ? "r" : "z";
    const [value, next] = [point?.[along] ?? 0, beyond?.[along] ?? 0];
    return { at, axis: along, value, behind: next > value ? 1 : -1 };
  };
  return { limits: [of("u", "limitU", called.u <= limit.u ? 1 : -1), of("v", "limitV", called.v >= limit.v ? -1 : 1)] };
}
