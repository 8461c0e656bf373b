import type { Step } from "../../kernel/time/step.ts";
import { loadAlong, type PathLoad } from "../../sim/load/along.ts";
import type { Answer, TaskMark } from "./judgement.ts";

function loadOf({ run }: Answer): PathLoad {
  const going = loadAlong(run);
  for (;;) {
    const now = going.next();
    if (now.done) return now.value;
  }
}

/** Inserts that cut along a surface: their depth is the material above their path. A recessing blade cuts its width. */
const ALONG: ReadonlySet<string> = new Set(["ROUGH", "FINISH", "BUTTON"]);
/** A cut lies along the axis within this, mm. */
const LEVEL = 0.001;

/** Finishing cuts along a cylinder: they cut at once what was never roughed. */
const isFinishAlong = ({ operation, move, from, tool }: Step): boolean =>
  operation !== null &&
  move.phase === "finish" &&
  move.kind === "feed" &&
  Math.abs(move.to.r - from.r) < LEVEL &&
  ALONG.has(tool.TYPE);

/**
 * Moves outside cycles, and finishing cuts, that cut deeper than `limit` mm square to their path: each once, with its
 * greatest depth.
 */
export function depthsBeyondLimit(answer: Answer, limit: number): Partial<TaskMark>[] {
  const { steps } = answer.run;
  const isLooked = (step: Step) => (step.operation === null ? step.move.kind !== "rapid" : isFinishAlong(step));
  if (!steps.some(isLooked)) return [];
  const load = loadOf(answer);
  const deepest = new Map<number, number>();
  load.step.forEach((index, i) => {
    const [depth, step] = [load.depth[i] ?? 0, steps[index]];
    if (step && isLooked(step) && depth > Math.max(limit, deepest.get(index) ?? 0)) deepest.set(index, depth);
  });
  return [...deepest].map(([index, value]) => {
    const { operation = null, block = 0 } = steps[index] ?? {};
    return { value, limit, step: index, block, ...(operation !== null && { operation }) };
  });
}
