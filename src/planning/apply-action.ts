import { areaOf } from "../kernel/area/area.ts";
import { difference, intersection, opened, union } from "../kernel/area/clip.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import { at, type Ring } from "../kernel/geometry/point.ts";
import { diameter, perSide } from "../kernel/units.ts";
import { parse } from "../nc/parse.ts";
import { perObject } from "../nc/per-object.ts";
import type { Program } from "../nc/program.ts";
import { withHandOperation, withOperation, type OperationPlace } from "../program/edits/added-operation.ts";
import { emptyProgram } from "../program/job/empty-program.ts";
import type { SetJob } from "../program/job/job.ts";
import { runOn } from "../program/run/run.ts";
import { verdictOf, type VerdictReason } from "../report/verdict.ts";
import { simulate, simulateCuts } from "../sim/simulate.ts";
import type { Simulation } from "../sim/simulation.ts";
import {
  FINISHING,
  type Action,
  type PlannedPart,
  type PlanRequest,
  type PlanState,
  type TriedAction,
} from "./types.ts";

/** Less is no cut, mm² of the half plane. */
const LEAST_CUT = 0.05;
/** Less is no damage, mm²: chords of arcs. */
export const LEAST_GOUGE = 0.01;

/** Material beyond its oversize that a finishing cut takes at most, mm: the ground of an undercut, an edge. */
export const THICKEST = 1.5;

/** What a setter should see, and what says nothing about the stock: an operation without a cycle. */
const NO_FAULT: ReadonlySet<VerdictReason["kind"]> = new Set([
  "notes",
  "holderUnknown",
  "flanksUnknown",
  "curvatureUnknown",
  "noOperation",
]);

/** A program with the blocks of an action added; a tailstock is passed across the axis. */
export function withAction(
  program: Program,
  { job, cut }: Action,
  { labels, clamping }: Pick<PlanRequest, "labels" | "clamping">,
  place?: OperationPlace,
): Program {
  const { kind, tailstock } = clamping?.clamping ?? {};
  const held: SetJob =
    kind && tailstock ? { ...job, clamping: { kind, words: { QUILL: String(tailstock.quill) } } } : job;
  return cut ? withHandOperation(program, held, cut, place) : withOperation(program, held, labels, place);
}

const placeOf = ({ place: { front, rear, high, low } }: Action): Ring => [
  at(rear, low),
  at(front, low),
  at(front, high),
  at(rear, high),
];

/** Area of `a` outside `b` that is thicker than the error of chords, mm². */
export function areaBeyond(a: readonly Ring[], b: readonly Ring[]): number {
  const beyond = difference(a, b);
  return areaOf(beyond) < LEAST_GOUGE ? 0 : areaOf(opened(beyond, SLIVER));
}

/**
 * The stock after a run. What was parted off is the part, and the rest of the bar no longer counts. The grooves of a
 * thread are no area: where one is cut, the crest stays as `crests` have it.
 */
export function leftBy(
  { final, proof }: Pick<Simulation, "final" | "proof">,
  actions: readonly Action[],
  crests: readonly Ring[],
): readonly Ring[] {
  const parted = proof.loose.filter(({ isPartedOff }) => isPartedOff).flatMap(({ rings }) => rings);
  const left = parted.length > 0 ? parted : final;
  const threaded = actions.filter(({ threads }) => threads.length > 0).map(placeOf);
  return threaded.length > 0 ? union(left, intersection(crests, threaded)) : left;
}

/** Greatest oversize that a finishing cut takes with the ground of an undercut, mm. */
export const thickestOf = ({ rules }: Pick<PlanRequest, "rules">): number =>
  perSide(diameter(rules.allowance.diameter)) + THICKEST;

/** What of the finished part is in a stock. */
const ownIn = perObject(({ rings }: PlannedPart) => perObject((stock: readonly Ring[]) => intersection(stock, rings)));

/** What every try begins with. */
const EMPTY = parse(emptyProgram("PLAN", null));

/** Runs one action on the stock of a state. `isMeasured`: with all that is found in its passes, for one that is shown. */
export function runAction(
  action: Action,
  { stock }: Pick<PlanState, "stock">,
  request: PlanRequest,
  isMeasured = false,
) {
  const made = runOn(stock, withAction(EMPTY, action, request), request.shop);
  const input = { ...made, clamping: request.clamping, held: request.blank };
  const most = FINISHING.has(action.kind) ? thickestOf(request) : Infinity;
  return { made, simulation: isMeasured ? simulate(input) : simulateCuts(input, most) };
}

/**
 * Runs one action on the stock of a state and measures what it takes. After parting off the stock is the part. `ran`:
 * where it was run before.
 */
export function applyAction(
  action: Action,
  state: Pick<PlanState, "stock">,
  request: PlanRequest,
  { made, simulation }: ReturnType<typeof runAction> = runAction(action, state, request),
): TriedAction {
  const { part } = request,
    { stock } = state;
  const most = thickestOf(request);
  // Only the cut of a thread is no area.
  const isArea = action.threads.length === 0;
  const faults = verdictOf(made, simulation).reasons.filter(
    ({ kind }) => !NO_FAULT.has(kind) && !(isArea && kind === "nothingCut"),
  );
  const own = ownIn(part)(stock);
  const left = leftBy(simulation, [action], own);
  const { cut, operations } = simulation.proof;
  const isThick = FINISHING.has(action.kind) && operations.some(({ thickest }) => (thickest?.depth ?? 0) > most);
  const gouge = areaBeyond(own, left);
  const isMade = !isArea || cut > LEAST_CUT;
  return {
    action,
    stock: left,
    seconds: simulation.totalSeconds,
    cut,
    gouge,
    faults,
    works: faults.length === 0 && !isThick && gouge < LEAST_GOUGE && isMade,
  };
}
