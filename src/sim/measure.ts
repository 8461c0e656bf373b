import { QUESTIONS } from "./causes.ts";
import { areaOf } from "../kernel/area/area.ts";
import { intersection, offset, simplified } from "../kernel/area/clip.ts";
import type { Box } from "../kernel/geometry/segments.ts";
import type { Move } from "../kernel/plan/move.ts";
import type { MachiningLimit } from "../kernel/plan/plan.ts";
import { at, type Pt, type Ring } from "../kernel/geometry/point.ts";
import { REAL_AREA, withoutSlivers } from "../kernel/area/real-area.ts";
import type { Step } from "../kernel/time/step.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import { boxAround, inBox } from "../kernel/area/box.ts";
import { inStock } from "./contact.ts";
import { crestMissing } from "./crest.ts";
import type { Cutting, Present } from "./cutting.ts";
import { deepestAlong, hasRoomFor, thicknessOf } from "./extent.ts";
import type { Outlines } from "./outlines.ts";
import { piecesOf } from "./piece.ts";
import { largest, placeIn } from "./region.ts";
import type { BehindLimit, Depth, MissingCrest, OperationProof, SimulatedOperation, ThreadWay } from "./simulation.ts";
import { foldedAtAxis, type Sweep } from "./sweep.ts";

/** Tolerance above the allowed depth of cut, mm. */
const DEPTH_TOLERANCE = 0.05;
/** Material this little behind a machining limit is not reported, mm (decision 0034). */
const LIMIT_TOLERANCE = 0.1;
/** In a right-angle bend, a layer of even thickness has room for a circle this many times as wide. */
const BEND = (2 * Math.SQRT2) / (1 + Math.SQRT2);
/** Most convex pieces of a measured stretch: joining them costs their square. */
const LONG = 100;

type Phase = Move["phase"];

/** Consecutive feed moves of the same work, with the stock before the first of them. */
interface Stretch {
  readonly operation: number;
  readonly phase: Phase;
  readonly run: Move["run"];
  readonly pass: number | undefined;
  readonly step: number;
  readonly before: Present;
  readonly sweeps: Sweep[];
  /** Convex pieces in all sweeps. */
  pieces: number;
}

/** A measured depth without its block: editing shifts blocks, but not steps. */
type Measured = Omit<Depth, "block">;
/** Material cut behind a limit, without its block; `roughing`: roughing cut some of it. */
type Crossed = Omit<BehindLimit, "block" | "place" | "finishing"> & { readonly roughing: boolean };

interface Sums {
  cut: number;
  readonly passes: Map<number, number>;
  deepest: Measured | null;
  thickest: Measured | null;
  startInMaterial: Pt | null;
  crossed: readonly Crossed[];
  /** Absent until the first pass of a thread. */
  crest?: MissingCrest | null;
}

/** The state of the measurement before a step. */
export interface MeasuredSoFar {
  /** The operation of that step, and its unfinished stretch. */
  readonly operation: number | null;
  readonly run: Stretch | null;
  /** Measurements of the operations that moved before that step, by operation; one that did not move has none. */
  readonly sums: ReadonlyMap<number, Sums>;
}

/** Measures the effect of each operation on the stock. */
export interface StockMeasure {
  /** Adds a step and its sweep, before the sweep is subtracted from the stock. */
  add(step: Step, index: number, sweep: Sweep, outlines: Outlines, cut: Cutting): void;
  /** The state before a step of an operation. */
  state(operation: number | null): MeasuredSoFar;
  /** The results, with blocks taken from the steps. */
  results(steps: readonly Step[]): OperationProof[];
}

/** The greatest infeed that a plan allows, mm; 0 when its values set none. */
const mostOf = ({ plan }: SimulatedOperation) => plan.maxInfeed;

/** The greatest cut of smoothing or finishing, square to its path, mm: oversize plus one infeed; 0 when unknown. */
function mostFinishingCut({ plan }: SimulatedOperation): number {
  const infeed = plan.maxInfeed > 0 ? plan.maxInfeed : plan.infeed;
  return plan.oversize && infeed > 0 ? Math.max(plan.oversize.z, plan.oversize.r) + infeed : 0;
}

const copyOf = (sums: Sums): Sums => ({ ...sums, passes: new Map(sums.passes) });

const UNMEASURED = (): Sums => ({
  cut: 0,
  passes: new Map(),
  deepest: null,
  thickest: null,
  startInMaterial: null,
  crossed: [],
});

/**
 * Starts measuring a run, or resumes where an earlier run was the same up to a step. `thickerThan`: measured is only
 * whether a thread cuts, and how thick finishing cuts are that are thicker than this, mm.
 */
export function measuring(
  operations: readonly SimulatedOperation[],
  blank: readonly Ring[],
  before: MeasuredSoFar | null = null,
  thickerThan: number | null = null,
): StockMeasure {
  // Operations that have ended are shared between runs; the one that resumes is measured on.
  const sums = new Map(before?.sums);
  const resumed = before?.operation ?? null;
  const begun = resumed === null ? undefined : sums.get(resumed);
  if (resumed !== null && begun) sums.set(resumed, copyOf(begun));
  let run: Stretch | null = before?.run ? { ...before.run, sweeps: [...before.run.sweeps] } : null;

  function sumsOf(operation: number): Sums {
    const known = sums.get(operation) ?? UNMEASURED();
    sums.set(operation, known);
    return known;
  }

  function close(): void {
    const done = run;
    run = null;
    const operation = done ? operations[done.operation] : undefined;
    if (!done || !operation) return;
    const sum = sumsOf(done.operation);
    const passes = done.phase === "rough" && done.pass !== undefined;
    const isKnown = done.phase === "thread" ? sum.cut >= REAL_AREA : passes || thickerThan === Infinity;
    if (thickerThan !== null && isKnown) return;
    const taken = inStock(done.sweeps, done.before);
    const area = areaOf(taken);
    sum.cut += area;
    // The air passes (spring cuts) after the passes of a thread are intended.
    const threads = done.phase === "thread" && done.pass !== undefined && done.pass <= operation.plan.passes;
    if ((passes || threads) && done.pass !== undefined)
      sum.passes.set(done.pass, (sum.passes.get(done.pass) ?? 0) + area);
    if (area < REAL_AREA || (thickerThan !== null && done.phase === "thread")) return;
    if (thickerThan === null)
      for (const limit of operation.plan.limits ?? []) sum.crossed = crossing(sum.crossed, limit, taken, done);
    const place = { step: done.step, ...(done.pass !== undefined && { pass: done.pass }) };
    if (passes && operation.plan.isParallel) sum.deepest = thicker(sum.deepest, taken, mostOf(operation), place, BEND);
    else if (passes || done.phase === "thread") sum.deepest = deeper(sum.deepest, taken, operation, place);
    else {
      const most = mostFinishingCut(operation);
      if (thickerThan === null || hasRoomFor(taken, thickerThan))
        sum.thickest = thicker(sum.thickest, taken, most, { step: done.step });
    }
  }

  function belongs(step: Step, operation: number): boolean {
    return (
      run !== null &&
      run.operation === operation &&
      run.phase === step.move.phase &&
      run.pass === step.move.pass &&
      run.pieces < LONG
    );
  }

  return {
    add(step, index, sweep, outlines, cut) {
      const { operation } = step;
      if (operation === null || step.move.kind === "rapid" || !belongs(step, operation)) close();
      if (operation === null) return;
      const sum = sumsOf(operation);
      const isFirst = thickerThan === null && operations[operation]?.firstStep === index;
      if (isFirst && standsIn(outlines.checked, step.from, cut)) sum.startInMaterial = step.from;
      if (step.move.kind === "rapid") return;
      if (thickerThan === null && sum.crest === undefined && step.move.phase === "thread")
        sum.crest = crestMissing((operations[operation] as SimulatedOperation).plan, cut.stock());
      run ??= {
        operation,
        phase: step.move.phase,
        run: step.move.run,
        pass: step.move.pass,
        step: index,
        before: cut.present(),
        sweeps: [],
        pieces: 0,
      };
      run.sweeps.push(sweep);
      run.pieces += sweep.pieces.length;
    },
    state(operation) {
      // A step of another operation ends the stretch.
      if (run?.operation !== operation) close();
      const own = operation === null ? undefined : sums.get(operation);
      const copy = new Map(sums);
      if (operation !== null && own) copy.set(operation, copyOf(own));
      return { operation, sums: copy, run: run && { ...run, sweeps: [...run.sweeps] } };
    },
    results(steps) {
      close();
      const atBlock = (depth: Measured | null): Depth | null =>
        depth && { ...depth, block: steps[depth.step]?.block ?? 0 };
      const behind = (crossed: readonly Crossed[], roughed: boolean): BehindLimit[] =>
        crossed.map(({ roughing, ...c }) => ({
          ...c,
          block: steps[c.step]?.block ?? 0,
          place: placeIn(c.ring),
          finishing: roughed && !roughing,
        }));
      return operations.map((operation, o) => {
        const { cut, passes, deepest, thickest, startInMaterial, crossed, crest } = sums.get(o) ?? UNMEASURED();
        const issues = operation.issues ?? [];
        return {
          cut,
          airPasses: [...passes.values()].filter((area) => area < REAL_AREA).length,
          crest: crest ?? null,
          thread: wayOf(operation),
          deepest: atBlock(deepest),
          thickest: atBlock(thickest),
          startInMaterial,
          behindLimits: behind(crossed, passes.size > 0),
          hasFailed: blank.length === 0 || issues.some((i) => i.severity === "error"),
          isQuestioned: issues.some((i) => QUESTIONS.has(i.code)),
        };
      });
    },
  };
}

function wayOf({ plan: { thread, openSide } }: SimulatedOperation): ThreadWay | null {
  return thread ? { crest: thread.crest, stop: thread.end, openSide } : null;
}

/** Whether an insert stands in the stock, on this side of the axis or on the other. */
function standsIn(insert: Ring, { z, r }: Pt, cut: Cutting): boolean {
  if (insert.length < 3) return false;
  const rings = foldedAtAxis(insert.map((p) => at(p.z + z, p.r + r)));
  return withoutSlivers(inStock([{ pieces: piecesOf(rings), rings }], cut.present())).length > 0;
}

type Where = Pick<Depth, "step" | "pass">;

/** An area sheared so that a thread's infeed direction becomes the open side: a pass steps along its flank. */
function upright(area: readonly Ring[], { openSide, thread }: SimulatedOperation["plan"]): readonly Ring[] {
  if (!thread || thread.slope === 0) return area;
  const { z, r } = thread.out;
  const across =
    Math.abs(openSide.r) >= Math.abs(openSide.z)
      ? (p: Pt): Pt => at(p.z - (z / r) * p.r, p.r)
      : (p: Pt): Pt => at(p.z, p.r - (r / z) * p.z);
  return area.map((ring) => ring.map(across));
}

/** The deeper of a depth and that of the area just cut, measured in the infeed direction. */
function deeper(
  known: Measured | null,
  taken: readonly Ring[],
  operation: SimulatedOperation,
  where: Where,
): Measured | null {
  const { openSide } = operation.plan;
  const box = boxAround(taken);
  const most = Math.abs(openSide.r) >= Math.abs(openSide.z) ? box.high - box.low : box.right - box.left;
  if (known && most <= known.depth + SLIVER) return known;
  const depth = deepestAlong(upright(taken, operation.plan), openSide);
  return depth > (known?.depth ?? 0) ? { depth, allowed: mostOf(operation), ...where } : known;
}

/**
 * The thicker of a finishing cut and the one just made, where it exceeds the allowed thickness; bends may exceed it by
 * BEND.
 */
function thicker(
  known: Measured | null,
  taken: readonly Ring[],
  allowed: number,
  where: Where,
  bend = 1,
): Measured | null {
  if (allowed === 0) return known;
  const told = Math.max(allowed * bend + DEPTH_TOLERANCE, known?.depth ?? 0);
  // Simplified first: the steps of a thousand passes in a wall take long to shrink, and are below the tolerance.
  const plain = simplified(taken, SLIVER);
  if (!hasRoomFor(plain, told) || offset(plain, -told / 2).length === 0) return known;
  return { depth: thicknessOf(plain), allowed, ...where };
}

/** The side behind a limit as a box. */
const behindOf = ({ axis, value, behind }: MachiningLimit): Box => {
  const box = { left: -Infinity, right: Infinity, low: -Infinity, high: Infinity };
  if (axis === "z") return behind > 0 ? { ...box, left: value } : { ...box, right: value };
  return behind > 0 ? { ...box, low: value } : { ...box, high: value };
};

/** How far a ring reaches behind a limit, mm. */
function behindBy(ring: Ring, { axis, value, behind }: MachiningLimit): number {
  const { left, right, low, high } = boxAround([ring]);
  const [least, most] = axis === "z" ? [left, right] : [low, high];
  return behind > 0 ? most - value : value - least;
}

/** The crossed limits so far, with the material that a run of moves cut behind one of them. */
function crossing(
  known: readonly Crossed[],
  limit: MachiningLimit,
  taken: readonly Ring[],
  done: Stretch,
): readonly Crossed[] {
  const box = behindOf(limit);
  const rings = withoutSlivers(inBox(taken, box).filter((ring) => behindBy(ring, limit) >= LIMIT_TOLERANCE));
  if (rings.length === 0) return known;
  const before = known.find((c) => c.limit.at === limit.at);
  const ring = largest(rings);
  const first = () =>
    done.step +
    Math.max(
      0,
      done.sweeps.findIndex((s) => withoutSlivers(intersection(inStock([s], done.before), [ring])).length > 0),
    );
  const isLarger = !before || areaOf([ring]) > areaOf([before.ring]);
  const crossed: Crossed = {
    limit,
    area: areaOf(rings) + (before?.area ?? 0),
    ...(isLarger ? { ring, step: first() } : { ring: before.ring, step: before.step }),
    roughing: done.run === "rough" || (before?.roughing ?? false),
  };
  return [...known.filter((c) => c !== before), crossed];
}

/** Whether a measured depth exceeds the allowed one beyond tolerance. */
export const isTooDeep = ({ depth, allowed }: Depth): boolean => allowed > 0 && depth > allowed + DEPTH_TOLERANCE;
