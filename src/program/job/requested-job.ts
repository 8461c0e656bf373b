import type { Cycle } from "../../cycles/define.ts";
import { worksAcross } from "../../cycles/use.ts";
import { beginsAtTip, valuesFor, type ShapeRequest } from "../../cycles/shape-request.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { diameter, radius, toDiameter, toRadius } from "../../kernel/units.ts";
import { exampleJob, type BlankDraft, type SetJob } from "./job.ts";
import { positionAsTyped } from "../values/typed-value.ts";
import { blankFor, requestedBox, rowsOf, requestedContour } from "./requested-shape.ts";

/** Clearance of the tip at the call, mm. */
const CLEARANCE = 2;
/** Run-up of a thread, mm: longer than the one added by its cycle. */
const RUN_UP = 5;

const numberOf = (typed: string) => Number(typed);

/** Orients a contour in the cutting direction: along Z away from its open side, or from outside towards its depth. */
function directed(contour: readonly Segment[], wanted: ShapeRequest, across: boolean): readonly Segment[] {
  const [first, last] = [contour[0]?.from, contour.at(-1)?.to];
  if (!first || !last) return contour;
  const { along, out } = requestedBox(wanted);
  const falls = across ? (first.r - last.r) * out : (first.z - last.z) * along;
  return falls < 0 ? contour.map(part.reversed).reverse() : contour;
}

/** Entry of a free contour: outside the blank, in front of the contour; for a recess at its open edge. */
function startOfFree({ group }: Cycle, wanted: ShapeRequest, contour: readonly Segment[], across: boolean): Pt {
  const box = boxOf(contour.flatMap((s) => [s.from, s.to]));
  const { r1, along, out } = requestedBox(wanted);
  const front = along > 0 ? box.right : box.left;
  const first = contour[0]?.from ?? at(front, r1);
  if (group === "recessTurning" || group === "recessing") return across ? at(front, first.r) : at(first.z, r1);
  const side = out > 0 ? Math.max(r1, box.high) : Math.min(r1, box.low);
  // A contour that begins at the open side descends into the material: the tip waits outside.
  const falls = (r1 - first.r) * out <= 0 && !across;
  return at(front + along * CLEARANCE, falls ? side + out * CLEARANCE : side);
}

/** Tip at the call of a cycle with its own contour. */
function startOfOwn(cycle: Cycle, wanted: ShapeRequest, across: boolean): Pt {
  const { z1, r1, along, out } = requestedBox(wanted);
  if (wanted.shape === "thread") return at(z1 + along * RUN_UP, r1 + out * RUN_UP);
  if (wanted.shape === "groove") return at(z1, r1);
  if (across) return at(z1, r1 + out * CLEARANCE);
  return wanted.shape === "plunge" && beginsAtTip(cycle) ? at(z1, r1) : at(z1 + along * CLEARANCE, r1);
}

/** Job that machines the requested shape with a cycle; its tool is still that of the printed example. */
export function jobFor(cycle: Cycle, wanted: ShapeRequest, stock: readonly Ring[] | null): SetJob {
  const across = worksAcross(cycle);
  const contour = directed(requestedContour(wanted), wanted, across);
  const start =
    cycle.contour === "free" ? startOfFree(cycle, wanted, contour, across) : startOfOwn(cycle, wanted, across);
  const values = Object.entries(valuesFor(cycle, wanted)).map(([q, value]) => [q, String(value)]);
  return {
    ...exampleJob(cycle),
    drafts: { [cycle.number]: Object.fromEntries(values) as Record<string, string> },
    blank: blankFor(wanted, stock),
    start: { x: positionAsTyped(toDiameter(radius(Math.max(0, start.r)))), z: positionAsTyped(start.z) },
    contour: cycle.contour === "free" ? rowsOf(contour) : [],
  };
}

/** The job with cycle values changed, each by its Q. */
export const withCycleValues = (job: SetJob, values: readonly (readonly [q: string, value: number])[]): SetJob => {
  const draft: Record<string, string> = { ...job.drafts[job.cycle] };
  for (const [q, value] of values) draft[q] = String(value);
  return { ...job, drafts: { ...job.drafts, [job.cycle]: draft } };
};

/** The job with one cycle value changed. */
export const withValue = (job: SetJob, q: string, value: number): SetJob => withCycleValues(job, [[q, value]]);

/** A typed cylinder as its half section. */
export function ringOf({ outside, bore, length, allowance }: BlankDraft): Ring {
  const [r, hole] = [numberOf(outside), numberOf(bore || "0")].map((d) => toRadius(diameter(d))) as [Pt["r"], Pt["r"]];
  const [front, back] = [numberOf(allowance), numberOf(allowance) - numberOf(length)];
  return [at(back, hole), at(front, hole), at(front, r), at(back, r)];
}

/** Tip at the call of a job with a numeric start point. */
export const tipAtCall = ({ start }: SetJob): Pt => at(numberOf(start.z), toRadius(diameter(numberOf(start.x))));
