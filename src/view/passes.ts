import type { Step } from "../kernel/time/step.ts";
import { moveData, startData } from "./path.ts";
import { PATH_ROLES, pathRole, tipWays, toolpath, type Shape, type TipWays } from "./scene.ts";

/** The lines that draw some moves, and the area that their tips reach. */
interface Drawn {
  readonly shapes: readonly Shape[];
  readonly ways: readonly TipWays[];
}

/** Consecutive moves, first and last included, and the lines that draw them. */
export interface PathStretch extends Drawn {
  readonly first: number;
  readonly last: number;
}

/**
 * Limit of path stretches that change their look one by one: more would slow down every frame, and could not be told
 * apart.
 */
export const MOST_STRETCHES = 96;

/** Whether a pass ends before a step: another call, phase or pass begins; between the cycles a rapid after a cut. */
function begins(before: Step, step: Step): boolean {
  const [was, is] = [before.move, step.move];
  if (before.operation !== step.operation || was.run !== is.run || was.pass !== is.pass) return true;
  return is.pass === undefined && is.kind === "rapid" && was.kind !== "rapid";
}

const beginsCall = (before: Step, step: Step): boolean =>
  step.operation !== null && step.operation !== before.operation;

/**
 * Least number of steps per stretch: one of 1, 2, 3, 4, 6, 8, 12 …. The number stays the same while a path grows a
 * little, so that unchanged moves form the same stretches again.
 */
function leastOf(count: number, most: number): number {
  const share = Math.max(1, count / most),
    power = 2 ** Math.ceil(Math.log2(share));
  return power > 2 && 0.75 * power >= share ? 0.75 * power : power;
}

/** Cached lines of stretches by their first step that a cycle made, so that unchanged stretches are not drawn again. */
export type KnownLines = WeakMap<Step, { readonly steps: readonly Step[]; readonly drawn: Drawn }>;

/** Steps of unchanged calls keep their identity; the moves between calls are new objects in each run. */
const drawsAlike = (a: Step | undefined, b: Step | undefined): boolean =>
  a?.operation === null &&
  b?.operation === null &&
  a.move.kind !== "arc" &&
  pathRole(a.move) === pathRole(b.move) &&
  moveData(a.from, a.move) === moveData(b.from, b.move) &&
  startData(a.from) === startData(b.from);

/** Whether some steps draw the same lines as others from an index on. */
function isAlike(some: readonly Step[], others: readonly Step[], from: number): boolean {
  for (let i = 0; i < some.length; i += 1)
    if (some[i] !== others[from + i] && !drawsAlike(some[i], others[from + i])) return false;
  return true;
}

function linesOf(steps: readonly Step[], from: number, to: number, known: KnownLines): Drawn {
  let called = from;
  while (called < to - 1 && steps[called]?.operation === null) called += 1;
  const key = steps[called],
    have = key && known.get(key);
  if (have?.steps.length === to - from && isAlike(have.steps, steps, from)) return have.drawn;
  const own = steps.slice(from, to),
    drawn = { shapes: toolpath(own), ways: tipWays(own) };
  if (key) known.set(key, { steps: own, drawn });
  return drawn;
}

/**
 * A part of a run as stretches of whole passes, in order, each with one path per form of line. With too many passes,
 * several consecutive ones share a stretch; a call still begins a new stretch unless the previous one would be very
 * short.
 */
export function pathStretches(
  steps: readonly Step[],
  first = 0,
  last = steps.length - 1,
  most = MOST_STRETCHES,
  known: KnownLines = new WeakMap(),
): readonly PathStretch[] {
  const least = leastOf(last - first + 1, most),
    shortest = Math.ceil(least / 2);
  const out: PathStretch[] = [];
  let from = first;
  for (let i = Math.max(first, Math.min(last, first + shortest - 1)); i <= last; i += 1) {
    const here = steps[i] as Step,
      next = steps[i + 1],
      size = i - from + 1;
    const ends =
      i === last || !next || (size >= least ? begins(here, next) : 2 * size >= least && beginsCall(here, next));
    if (!ends) continue;
    out.push({ first: from, last: i, ...linesOf(steps, from, i + 1, known) });
    from = i + 1;
    i = Math.max(i, Math.min(last, from + shortest - 1) - 1);
  }
  return out;
}

/** All stretches as one path for each form of line. */
export const wholePath = (stretches: readonly PathStretch[]): readonly Shape[] =>
  PATH_ROLES.flatMap((role) => {
    // The engine concatenates lazily: a long text is only built when it is read.
    let d = "";
    for (const { shapes } of stretches) d += shapes.find((shape) => shape.role === role)?.d ?? "";
    return d ? [{ role, d }] : [];
  });

/** How far a stretch is: to come, running or done. */
export type Progress = "coming" | "running" | "done";

/** The state of a stretch while a step runs; after the last step everything is done. */
export function progressOf({ first, last }: PathStretch, step: number): Progress {
  if (step > last) return "done";
  return step < first ? "coming" : "running";
}
