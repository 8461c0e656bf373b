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
import type { MeasuredSoFar } from "./measure.ts";
import { sameHold, type Parted } from "./work-holding.ts";
import type { Outlines } from "./outlines.ts";
import { isPlainCut, plainSince, type Surface } from "./plain-cut.ts";
import { sameRings, sameSteps } from "./same-step.ts";
import type { Checkpoint, SimulatedOperation, SimulationInput, AnyFinding } from "./simulation.ts";
import { sweptBy, waypoints } from "./sweep.ts";

/*
 * A changed run resumes where it still equals the previous one: stock, findings and measurements up to there are
 * reused.
 */

/** The state of a simulation before a step. */
export interface Snapshot {
  readonly step: number;
  readonly cut: Cutting;
  /** The step at which the stock was last recomputed, and the number of marks. */
  readonly marked: number;
  readonly marks: number;
  readonly byRapids: number;
  readonly measure: MeasuredSoFar;
}

/** The state of a simulation that the next one can reuse. */
export interface PreviousRun {
  readonly input: SimulationInput;
  readonly snapshots: readonly Snapshot[];
  readonly marks: readonly Checkpoint[];
  /** Damage by step index. */
  readonly damage: ReadonlyMap<number, readonly AnyFinding[]>;
  /** The finished part of the first set-up. */
  readonly finished: Finished;
  /** Pieces that came off. */
  readonly parted: readonly Parted[];
}

/** The snapshot to resume from, and earlier steps to check again because the finished part differs there. */
export interface ResumePoint {
  readonly from: Snapshot;
  readonly recheck: readonly number[];
}

/** Whether two plans agree in everything that measuring uses. */
const sameMeasure = ({ plan: a }: SimulatedOperation, { plan: b }: SimulatedOperation): boolean =>
  a.isParallel === b.isParallel &&
  a.maxInfeed === b.maxInfeed &&
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

/** The number of leading steps that two runs have in common; a blank stated later ends them. */
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

/** The bounding box of an outline's sweep in a step; null without an outline. */
export function sweptBox(outline: Ring, step: Step): Box | null {
  if (outline.length < 3) return null;
  const [own, way] = [boxOf(outline), boxOf(waypoints(step, 1))];
  const [low, high] = [own.low + way.low, own.high + way.high];
  // Parts beyond the axis are mirrored to this side.
  return {
    left: own.left + way.left,
    right: own.right + way.right,
    low: low < 0 ? 0 : low,
    high: Math.max(high, -low),
  };
}

/** True for boxes with nothing in common. */
export const areBoxesApart = (a: Box, b: Box): boolean =>
  a.right < b.left || b.right < a.left || a.high < b.low || b.high < a.low;

/** Verdicts on plain cuts. */
const JUDGED: ReadonlySet<AnyFinding["kind"]> = new Set(["gouge", "cutBelowContour", "intendedCut"]);

/**
 * Steps before a limit to check again: those that sweep where the two finished parts differ, and those that cut into
 * the previous finished part.
 */
function stepsToRecheck(
  former: PreviousRun,
  input: SimulationInput,
  { rings: finished, surfaces }: Finished,
  until: number,
  outlines: (tool: Step["tool"]) => Outlines,
) {
  const lines = (of: readonly Surface[]) => of.map(({ line }) => line);
  const isSame = sameRings(former.finished.rings, finished);
  const sameSurfaces = sameRings(lines(former.finished.surfaces), lines(surfaces));
  // Whether a plain cut is meant depends on the tool's next moves, which may have changed.
  const open = input.steps[until - 1]?.operation === null ? plainSince(input.steps, until - 1) : until;
  const judged = (i: number) => former.damage.get(i)?.some(({ kind }) => JUDGED.has(kind)) === true;
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
    if (!swept || areBoxesApart(swept, box)) return [];
    return sweptBy(checked, step).pieces.some((piece) => edges.meets(piece)) ? [i] : [];
  });
}

/** Whether a clamping is stated. */
export const hasClamping = ({ clamping }: SimulationInput): boolean => clamping !== null && clamping !== undefined;

/** Whether two runs start with the same blank and the same grip. */
const sameBlank = (a: SimulationInput, b: SimulationInput): boolean =>
  sameRings(a.blank, b.blank) &&
  sameRings(a.held ?? a.blank, b.held ?? b.blank) &&
  sameHold(a.clamping?.clamping ?? null, b.clamping?.clamping ?? null);

/** The first known run with the most leading steps in common with a new one. */
export function nearestRun(known: readonly PreviousRun[], input: SimulationInput): PreviousRun | null {
  const [first, ...others] = known;
  if (!first || others.length === 0) return first ?? null;
  const common = known.map((former) => (sameBlank(former.input, input) ? commonSteps(former.input, input) : -1));
  return known[common.indexOf(Math.max(...common))] ?? null;
}

/** Where a run can resume from a previous one; null without a common snapshot. */
export function resumePoint(
  former: PreviousRun,
  input: SimulationInput,
  finished: Finished,
  outlines: (tool: Step["tool"]) => Outlines,
): ResumePoint | null {
  if (!sameBlank(former.input, input)) return null;
  const common = commonSteps(former.input, input);
  // A step of another operation has closed the measurement before it.
  const from = former.snapshots.findLast(
    ({ step, measure }) =>
      step < common || (step === common && (input.steps[step]?.operation ?? null) === measure.operation),
  );
  return from ? { from, recheck: stepsToRecheck(former, input, finished, from.step, outlines) } : null;
}

/** Least steps between two snapshots, and about the most snapshots. */
const LEAST_STEPS = 8;
const MOST_SNAPSHOTS = 200;

/**
 * Selects the steps before which a snapshot is stored, besides the one at the end: starts of operations, and even
 * intervals.
 */
export function snapshotSteps({ steps, operations }: SimulationInput): (step: number) => boolean {
  const every = Math.max(LEAST_STEPS, Math.ceil(steps.length / MOST_SNAPSHOTS));
  const begins = new Set(operations.length <= MOST_SNAPSHOTS ? operations.map(({ firstStep }) => firstStep) : []);
  return (step) => step > 0 && (step % every === 0 || begins.has(step));
}
