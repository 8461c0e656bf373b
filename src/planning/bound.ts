import { cycleByNumber } from "../cycles/index.ts";
import { areaOf } from "../kernel/area/area.ts";
import { boxBeyond, inBox } from "../kernel/area/box.ts";
import { difference } from "../kernel/area/clip.ts";
import { insertOutline } from "../kernel/cutter/insert.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import type { Plan } from "../kernel/plan/plan.ts";
import { CHORD } from "../kernel/tolerance.ts";
import { tipAtCall } from "../program/job/requested-job.ts";
import { merged } from "../sim/cutting.ts";
import { sweptBy } from "../sim/sweep.ts";
import { secondsOfPlan } from "./actions/candidates.ts";
import { planOf } from "./actions/contour-job.ts";
import { turnedVolume } from "./stock-key.ts";
import { FINISHING, type Action, type PlanRequest } from "./types.ts";

/** The best that an action can do, as far as its path says before it is tried. */
export interface Bound {
  /** Least time, s; 0 for an action without a path of a cycle. */
  readonly seconds: number;
  /** Most material outside the finished part that it takes: mm² of the half plane (Infinity: not known), and mm³. */
  readonly area: number;
  readonly volume: number;
}

/** Areas that plans sweep: the same plan is asked for with each stock. */
const areas = new WeakMap<Plan, readonly Ring[]>();

/** Area that the feed moves of a plan sweep. */
function sweptArea(plan: Plan, { job, tool }: Action): readonly Ring[] {
  const known = areas.get(plan);
  if (known) return known;
  const { moves, tool: adapted } = plan;
  const insert = insertOutline(adapted ?? tool, CHORD);
  let from = tipAtCall(job);
  const rings = moves.flatMap((move) => {
    const step = { from, move, tool: adapted ?? tool, block: 0, operation: null, seconds: 0 };
    from = move.to;
    return move.kind === "rapid" ? [] : sweptBy(insert, step).rings;
  });
  const area = merged(rings);
  areas.set(plan, area);
  return area;
}

/** The bound of an action on the material that is open: what lies in its place, of a finishing cut what it sweeps. */
export function boundOf(action: Action, open: readonly Ring[], request: PlanRequest): Bound {
  const { kind, tool, job, cut, threads, place } = action;
  const cycle = cut || action.cycle === null ? undefined : cycleByNumber(action.cycle);
  const plan = cycle && planOf(cycle, job, tool, request.shop.memory);
  const seconds = plan ? secondsOfPlan({ job, plan }, request) : 0;
  const { front, rear, high, low } = place;
  if (!plan || !FINISHING.has(kind) || threads.length > 0)
    return { seconds, area: Infinity, volume: turnedVolume(inBox(open, { left: rear, right: front, low, high })) };
  const swept = sweptArea(plan, action);
  const there = inBox(open, boxBeyond(swept));
  const left = difference(there, swept);
  return { seconds, area: areaOf(there) - areaOf(left), volume: turnedVolume(there) - turnedVolume(left) };
}
