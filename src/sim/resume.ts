import { difference, offset } from "../kernel/area/clip.ts";
import { boxAround, boxOf } from "../kernel/area/box.ts";
import type { Box } from "../kernel/geometry/segments.ts";
import type { MachiningLimit } from "../kernel/plan/plan.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import type { Finished } from "./check.ts";
import type { Cutting } from "./cutting.ts";
import { sidesOf } from "./edges.ts";
import type { MeasuredSoFar, StockMeasure } from "./measure.ts";
import { sameHold, type Parted } from "./held.ts";
import type { Outlines } from "./outlines.ts";
import { isPlainCut, plainSince, type Surface } from "./plain-cut.ts";
import { sameRings, sameSteps } from "./same-step.ts";
import type { Checkpoint, SimulatedOperation, SimulationInput, AnyFinding } from "./simulation.ts";
import { sweptBy, waypoints } from "./sweep.ts";

/*
 * A changed run goes on from where it was the same: what stood there, what was found and measured until then is that of
 * the run before.
 */

/** How far a simulation has come before a step. */
export interface Snapshot {
  readonly step: number;
  readonly cut: Cutting;
  /** The step at which cutting began anew, and how many marks there are. */
  readonly marked: number;
  readonly marks: number;
  readonly byRapids: number;
  readonly measure: MeasuredSoFar;
}

/** What is kept of a simulation for the one that follows. */
export interface Former {
  readonly input: SimulationInput;
  readonly snapshots: readonly Snapshot[];
  readonly marks: readonly Checkpoint[];
  /** What each step did wrong, by its index. */
  readonly damage: ReadonlyMap<number, readonly AnyFinding[]>;
  readonly sums: ReturnType<StockMeasure["sums"]>;
  /** The finished part at the beginning. */
  readonly finished: Finished;
  /** What came off. */
  readonly parted: readonly Parted[];
}

/**
 * Where a simulation goes on, and the steps before that have to be looked at again, because the finished part is
 * another one there.
 */
export interface Resumed {
  readonly from: Snapshot;
  readonly recheck: readonly number[];
}

/** What the measure of an operation reads of its plan. */
const sameMeasure = ({ plan: a }: SimulatedOperation, { plan: b }: SimulatedOperation): boolean =>
  a.isParallel === b.isParallel &&
  a.most === b.most &&
  a.infeed === b.infeed &&
  a.oversize?.r === b.oversize?.r &&
  a.oversize?.z === b.oversize?.z &&
  a.openSide.z === b.openSide.z &&
  a.openSide.r === b.openSide.r &&
  a.thread?.out.z === b.thread?.out.z &&
  a.thread?.out.r === b.thread?.out.r &&
  sameLimits(a.limits ?? [], b.limits ?? []);

const sameLimits = (a: readonly MachiningLimit[], b: readonly MachiningLimit[]): boolean =>
  a.length === b.length &&
  a.every((l, i) => l.at === b[i]?.at && l.axis === b[i].axis && l.value === b[i].value && l.behind === b[i].behind);

/** The number of steps that two runs have in common at their beginning; a blank that is stated later ends it. */
function commonSteps(a: SimulationInput, b: SimulationInput): number {
  const same = sameSteps();
  const most = Math.min(
    a.steps.length,
    b.steps.length,
    ...[a, b].map(({ stated = [] }) => stated[0]?.step ?? Infinity),
  );
  let count = 0;
  for (; count < most; count += 1) {
    const [before, step] = [a.steps[count] as Step, b.steps[count] as Step];
    if (!same(before, step)) break;
    const [was, is] = step.operation === null ? [] : [a.operations[step.operation], b.operations[step.operation]];
    if (was && is && was.plan !== is.plan && !sameMeasure(was, is)) break;
  }
  return count;
}

/** The box of what an outline sweeps in a step; null where it has none. */
export function sweptBox(outline: Ring, step: Step): Box | null {
  if (outline.length < 3) return null;
  const [own, way] = [boxOf(outline), boxOf(waypoints(step, 1))];
  const [low, high] = [own.low + way.low, own.high + way.high];
  // What lies across the axis turns round to this side.
  return {
    left: own.left + way.left,
    right: own.right + way.right,
    low: low < 0 ? 0 : low,
    high: Math.max(high, -low),
  };
}

/** True for boxes with nothing in common. */
export const apart = (a: Box, b: Box): boolean =>
  a.right < b.left || b.right < a.left || a.high < b.low || b.high < a.low;

/** The steps before one that sweep where two finished parts differ, and those that have cut into the one before. */
function touching(
  former: Former,
  input: SimulationInput,
  { rings: finished, surfaces }: Finished,
  until: number,
  outlines: (tool: Step["tool"]) => Outlines,
) {
  const lines = (of: readonly Surface[]) => of.map(({ line }) => line);
  const isSame = sameRings(former.finished.rings, finished);
  const sameSurfaces = sameRings(lines(former.finished.surfaces), lines(surfaces));
  // What is meant with a plain cut shows in what its tool does next, which may be something else now.
  const open = input.steps[until - 1]?.operation === null ? plainSince(input.steps, until - 1) : until;
  const judged = (i: number) =>
    former.damage.get(i)?.some(({ kind }) => kind === "gouge" || kind === "cutBelowContour") === true;
  if (isSame) {
    const first = sameSurfaces ? open : 0;
    return [...former.damage.keys()]
      .filter((i) => i >= first && i < until && judged(i) && isPlainCut(input.steps[i]))
      .sort((a, b) => a - b);
  }
  const differs = offset(
    [...difference(former.finished.rings, finished), ...difference(finished, former.finished.rings)],
    SLIVER,
  );
  const [edges, box] = [sidesOf(differs), differs.length > 0 ? boxAround(differs) : null];
  return input.steps.slice(0, until).flatMap((step, i) => {
    if (judged(i)) return [i];
    const { checked } = outlines(step.tool);
    const swept = box && sweptBox(checked, step);
    if (!swept || apart(swept, box)) return [];
    return sweptBy(checked, step).pieces.some((piece) => edges.meets(piece)) ? [i] : [];
  });
}

/** Whether what holds the work is stated. */
export const hasClamping = ({ clamping }: SimulationInput): boolean => clamping !== null && clamping !== undefined;

/** Whether two runs begin with the same blank, held in the same places. */
const sameBlank = (a: SimulationInput, b: SimulationInput): boolean =>
  sameRings(a.blank, b.blank) && sameHold(a.clamping?.clamping ?? null, b.clamping?.clamping ?? null);

/**
 * Of some runs the one that has most in common with another at its beginning, where something of that was kept; the
 * first of them.
 */
export function nearestRun(known: readonly Former[], input: SimulationInput): Former | null {
  const [first, ...others] = known;
  if (!first || others.length === 0) return first ?? null;
  const common = known.map((former) => (sameBlank(former.input, input) ? commonSteps(former.input, input) : -1));
  return known[common.indexOf(Math.max(...common))] ?? null;
}

/** Where a run goes on from the one before it; null where they have nothing in common that was kept. */
export function resumed(
  former: Former,
  input: SimulationInput,
  finished: Finished,
  outlines: (tool: Step["tool"]) => Outlines,
): Resumed | null {
  if (!sameBlank(former.input, input)) return null;
  const common = commonSteps(former.input, input);
  // A step of another operation has ended what was measured before it.
  const from = former.snapshots.findLast(
    ({ step, measure }) =>
      step < common || (step === common && (input.steps[step]?.operation ?? null) === measure.operation),
  );
  return from ? { from, recheck: touching(former, input, finished, from.step, outlines) } : null;
}

/** Steps between two snapshots at least, and snapshots that are kept about. */
const LEAST_STEPS = 8;
const MOST_SNAPSHOTS = 200;

/**
 * Before which steps of a run a snapshot is kept, beside the one at its end: where operations begin, and at even
 * distances.
 */
export function snapshotSteps({ steps, operations }: SimulationInput): (step: number) => boolean {
  const every = Math.max(LEAST_STEPS, Math.ceil(steps.length / MOST_SNAPSHOTS));
  const begins = new Set(operations.length <= MOST_SNAPSHOTS ? operations.map(({ firstStep }) => firstStep) : []);
  return (step) => step > 0 && (step % every === 0 || begins.has(step));
}
