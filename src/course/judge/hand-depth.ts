import { loadAlong, type PathLoad } from "../../sim/load/along.ts";
import type { Answer, TaskMark } from "./judgement.ts";

function loadOf({ run }: Answer): PathLoad {
  const going = loadAlong(run);
  for (;;) {
    const now = going.next();
    if (now.done) return now.value;
  }
}

/** Moves outside of cycles that take more than `limit` mm square to their path, each once with the most that it takes. */
export function unknownDepths(answer: Answer, limit: number): Partial<TaskMark>[] {
  const { steps } = answer.run;
  if (!steps.some((step) => step.operation === null && step.move.kind !== "rapid")) return [];
  const load = loadOf(answer);
  const deepest = new Map<number, number>();
  load.step.forEach((step, i) => {
    const [depth, own] = [load.depth[i] ?? 0, steps[step]];
    if (own?.operation === null && depth > Math.max(limit, deepest.get(step) ?? 0)) deepest.set(step, depth);
  });
  return [...deepest].map(([step, value]) => ({ value, limit, step, block: steps[step]?.block ?? 0 }));
}
