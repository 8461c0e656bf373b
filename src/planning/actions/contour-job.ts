import type { Cycle } from "../../cycles/define.ts";
import type { ShapeRequest } from "../../cycles/shape-request.ts";
import { worksAcross } from "../../cycles/use.ts";
import { boxAround } from "../../kernel/area/box.ts";
import type { Plan } from "../../kernel/plan/plan.ts";
import type { AnswerCache } from "../../kernel/answer-cache.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { part, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { radius, rounded, roundedUp, toDiameter } from "../../kernel/units.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import type { SetJob } from "../../program/job/job.ts";
import { readDraft } from "../../program/job/read-draft.ts";
import { jobFor, tipAtCall } from "../../program/job/requested-job.ts";
import { boxAroundContour, cylinderAround } from "../../program/job/requested-shape.ts";
import { positionAsTyped } from "../../program/values/typed-value.ts";
import { perObject, perText } from "../../nc/per-object.ts";
import { highest } from "./outside-work.ts";

/** Clearance of a start point in front of the stock, and above it where the tool goes down into a valley, mm. */
const [AHEAD, ABOVE] = [2, 0.5];

/** Which way a cycle works along its contour. */
export type Way = "ahead" | "back";

/** A section of the contour that a cycle works on, in a stock. */
export interface ContourWork {
  /** From the front to the rear. */
  readonly segments: readonly Segment[];
  readonly way: Way;
  readonly stock: readonly Ring[];
}

/** Jobs of sections, by the cycle and the way, in each stock: every tool asks for them. */
const jobsOf = perObject((_: readonly Segment[]) => perText<(stock: readonly Ring[]) => SetJob>());

/** The job of a cycle that takes a contour of a subprogram: the section, and a start clear of the stock. */
export function contourJob(cycle: Cycle, { segments, way, stock }: ContourWork): SetJob {
  const inStock = () => {
    const job = sectionJob(cycle, segments, way);
    return perObject((stock: readonly Ring[]): SetJob => {
      const { z, r } = startOf(cycle, { segments, way, stock });
      return {
        ...job,
        blank: cylinderAround(stock),
        start: { x: positionAsTyped(roundedUp(toDiameter(radius(r)))), z: positionAsTyped(rounded(z)) },
      };
    });
  };
  return jobsOf(segments)(`${cycle.number} ${way}`, inStock)(stock);
}

/** What is the same of such a job in all stocks. */
function sectionJob(cycle: Cycle, segments: readonly Segment[], way: Way): SetJob {
  const { from, to } = boxAroundContour(segments, "outside");
  const isBack = way === "back";
  const wanted: ShapeRequest = {
    site: "outside",
    shape: "free",
    from: { ...from, z: isBack ? to.z : from.z },
    to: { ...to, z: isBack ? from.z : to.z },
    angle: 0,
    pitch: 1,
    contour: segments,
    allowance: 0,
  };
  return jobFor(cycle, wanted, null);
}

/** Where the tip waits, clear of the stock on the open side of the section. */
function startOf(cycle: Cycle, { segments, way, stock }: ContourWork): { readonly z: number; readonly r: number } {
  const points = part.flattenedChain(segments, CHORD);
  const { left, right, high } = boxAround([points]);
  const all = boxAround(stock);
  const above = Math.max(high, highest(stock, left, right)) + ABOVE;
  const recesses = cycle.group === "recessTurning" || cycle.group === "recessing";
  if (worksAcross(cycle)) {
    const front = Math.max(right, ...stock.flat().flatMap((p) => (p.z >= left ? [p.z] : [])));
    return recesses
      ? { z: front + ABOVE, r: points[0]?.r ?? high }
      : { z: front, r: Math.max(high, highest(stock, left, all.right)) + AHEAD };
  }
  if (recesses) return { z: points[0]?.z ?? right, r: above };
  const z = way === "back" ? left - AHEAD : right + AHEAD;
  const top = Math.max(high, highest(stock, left, right));
  const clear = highest(stock, way === "back" ? z - AHEAD : z, way === "back" ? left : z + AHEAD);
  // In front of the stock the tip waits at its height, in a valley above it.
  return way === "ahead" && z > all.right ? { z, r: top } : { z, r: Math.max(top, clear) + ABOVE };
}

/** The contour of the rows of a job, read once for all tools. */
const contourOf = perObject((rows: SetJob["contour"]): readonly Segment[] => readRows(rows).contour.segments);

/** The plan of a job with a tool; null where its values or its contour make none. Cached where there is a memory. */
export function planOf(cycle: Cycle, job: SetJob, tool: Tool, memory?: AnswerCache): Plan | null {
  if (!memory) return madePlan(cycle, job, tool);
  const asked = JSON.stringify([job.start, job.drafts[cycle.number]]);
  return memory.cached(
    `planned ${cycle.number} ${memory.nameOf(tool)} ${memory.nameOf(job.contour)} ${asked}`,
    () => madePlan(cycle, job, tool),
    (plan) => plan?.moves.length ?? 1,
  );
}

function madePlan(cycle: Cycle, job: SetJob, tool: Tool): Plan | null {
  const { values } = readDraft(cycle, job.drafts[cycle.number] ?? {});
  if (!values) return null;
  const start = tipAtCall(job);
  const contour = cycle.contour === "free" ? contourOf(job.contour) : null;
  return cycle.plan(values, { start, tool, feedUnit: "mm/rev", autoFeed: null, stock: null }, { contour, start });
}
