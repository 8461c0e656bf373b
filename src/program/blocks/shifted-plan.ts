import type { Plan, ThreadPlan } from "../../kernel/plan/plan.ts";
import type { Move } from "../../kernel/plan/move.ts";
import type { Pt, Segment } from "../../kernel/geometry/point.ts";
import { axial, radius } from "../../kernel/units.ts";
import type { Datum } from "../state/modal.ts";

type By = Pick<Datum, "x" | "z">;

export const shiftedPoint = (p: Pt, by: By): Pt => ({ z: axial(p.z + by.z), r: radius(p.r + by.x) });
/** A workpiece point in program coordinates. */
export const countedPoint = (p: Pt, by: By): Pt => ({ z: axial(p.z - by.z), r: radius(p.r - by.x) });

/** A contour segment in program coordinates, moved by the datum shift to the workpiece. */
export const shiftedSegment = (s: Segment, by: By): Segment => {
  const ends = { from: shiftedPoint(s.from, by), to: shiftedPoint(s.to, by) };
  return s.kind === "line" ? { ...s, ...ends } : { ...s, ...ends, centre: shiftedPoint(s.centre, by) };
};

const move = (m: Move, by: By): Move =>
  m.kind === "arc"
    ? { ...m, to: shiftedPoint(m.to, by), centre: shiftedPoint(m.centre, by) }
    : { ...m, to: shiftedPoint(m.to, by) };

const shiftedThread = (thread: ThreadPlan, by: By): ThreadPlan => ({
  ...thread,
  above: thread.above.map((p) => shiftedPoint(p, by)),
  crest: thread.crest.map((p) => shiftedPoint(p, by)),
  end: shiftedPoint(thread.end, by),
});

/** A plan in program coordinates, moved by the datum shift to the workpiece. */
export function shiftedPlan(plan: Plan, by: By): Plan {
  if (by.x === 0 && by.z === 0) return plan;
  const reach = (all: Plan["reach"]) => all.map((r) => ({ ...r, path: shiftedSegment(r.path, by) }));
  return {
    ...plan,
    moves: plan.moves.map((m) => move(m, by)),
    contour: plan.contour.map((s) => shiftedSegment(s, by)),
    area: plan.area.map((p) => shiftedPoint(p, by)),
    part: plan.part.map((p) => shiftedPoint(p, by)),
    ...(plan.thread && { thread: shiftedThread(plan.thread, by) }),
    reach: reach(plan.reach),
    oversizeReach: reach(plan.oversizeReach),
    ...(plan.unlimited && { unlimited: reach(plan.unlimited) }),
    ...(plan.limits && { limits: plan.limits.map((l) => ({ ...l, value: l.value + (l.axis === "r" ? by.x : by.z) })) }),
  };
}
