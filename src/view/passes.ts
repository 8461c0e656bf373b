import type { Step } from "../kernel/step.ts";
import { PATH_ROLES, toolpath, type Shape } from "./scene.ts";

/** Moves that follow one another, first and last included, and the lines that draw them. */
export interface PathStretch {
  readonly first: number;
  readonly last: number;
  readonly shapes: readonly Shape[];
}

/** Stretches of a path that may change their look one by one: more would cost every picture, and could not be told apart. */
export const MOST_STRETCHES = 96;

/** Whether a pass ends before a step: another call, phase or pass begins; between the cycles a rapid after a cut. */
function begins(before: Step, step: Step): boolean {
  const [was, is] = [before.move, step.move];
  if (before.operation !== step.operation || was.run !== is.run || was.pass !== is.pass) return true;
  return is.pass === undefined && is.kind === "rapid" && was.kind !== "rapid";
}

/**
 * A part of a run as stretches of whole passes, in their order, each with a path for every form of line. Where there are too many
 * passes, several that follow one another are one stretch.
 */
export function pathStretches(steps: readonly Step[], first = 0, last = steps.length - 1, most = MOST_STRETCHES): readonly PathStretch[] {
  const least = Math.ceil((last - first + 1) / most);
  const out: PathStretch[] = [];
  let from = first;
  for (let i = first; i <= last; i += 1) {
    const [here, next] = [steps[i], steps[i + 1]];
    const ends = i === last || (i - from + 1 >= least && here !== undefined && next !== undefined && begins(here, next));
    if (!ends) continue;
    out.push({ first: from, last: i, shapes: toolpath(steps.slice(from, i + 1)) });
    from = i + 1;
  }
  return out;
}

/** All stretches as one path for each form of line. */
export const wholePath = (stretches: readonly PathStretch[]): readonly Shape[] =>
  PATH_ROLES.flatMap((role) => {
    const d = stretches.map(({ shapes }) => shapes.find((shape) => shape.role === role)?.d ?? "").join("");
    return d ? [{ role, d }] : [];
  });

/** How far a stretch is: to come, running or done. */
export type Progress = "coming" | "running" | "done";

/** What is said of a stretch while a step runs; behind the last step everything is done. */
export function progressOf({ first, last }: PathStretch, step: number): Progress {
  if (step > last) return "done";
  return step < first ? "coming" : "running";
}
