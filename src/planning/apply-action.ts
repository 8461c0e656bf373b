import { areaOf } from "../kernel/area/area.ts";
import { opened, intersection, difference } from "../kernel/area/clip.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { parse } from "../nc/parse.ts";
import type { Program } from "../nc/program.ts";
import { withHandOperation, withOperation, type OperationPlace } from "../program/edits/added-operation.ts";
import { emptyProgram } from "../program/job/empty-program.ts";
import { cylinderAround } from "../program/job/requested-shape.ts";
import { run } from "../program/run/run.ts";
import { verdictOf, type VerdictReason } from "../report/verdict.ts";
import { simulateCuts } from "../sim/simulate.ts";
import type { Action, PlanRequest, PlanState, TriedAction } from "./types.ts";

/** Less is no cut, mm² of the half plane. */
const LEAST_CUT = 0.05;
/** Less is no damage, mm²: chords of arcs. */
const LEAST_GOUGE = 0.01;

/** Reasons that do not count against an action: a tool that is not described in full, and notes. */
const UNCHECKED: ReadonlySet<VerdictReason["kind"]> = new Set([
  "notes",
  "holderUnknown",
  "flanksUnknown",
  "curvatureUnknown",
]);

/** A program with the blocks of an action added. */
export const withAction = (
  program: Program,
  { job, cut }: Action,
  labels: PlanRequest["labels"],
  place?: OperationPlace,
) => (cut ? withHandOperation(program, job, cut, place) : withOperation(program, job, labels, place));

/** Area of `a` outside `b` that is thicker than the error of chords, mm². */
export const areaBeyond = (a: readonly Ring[], b: readonly Ring[]): number => areaOf(opened(difference(a, b), SLIVER));

/** Runs one action on the stock of a state and measures what it takes. After parting off the stock is the part. */
export function applyAction(action: Action, { stock }: Pick<PlanState, "stock">, request: PlanRequest): TriedAction {
  const { labels, part, shop, clamping } = request;
  const program = withAction(parse(emptyProgram("PLAN", cylinderAround(stock))), action, labels);
  const made = run(program, shop);
  const simulation = simulateCuts({ ...made, blank: stock, clamping });
  const { reasons } = verdictOf(made, simulation);
  const faults = reasons.filter(({ kind }) => !UNCHECKED.has(kind) && !(action.cut && kind === "noOperation"));
  // What is parted off is the part; the rest of the bar no longer counts.
  const parted = simulation.proof.loose.filter(({ isPartedOff }) => isPartedOff).flatMap(({ rings }) => rings);
  const left = parted.length > 0 ? parted : simulation.final;
  const { cut } = simulation.proof;
  const gouge = areaBeyond(intersection(stock, part.rings), left);
  const isMade = action.threads.length > 0 || cut > LEAST_CUT;
  return {
    action,
    stock: left,
    seconds: simulation.totalSeconds,
    cut,
    gouge,
    faults,
    works: faults.length === 0 && gouge < LEAST_GOUGE && isMade,
  };
}
