import type { TaskProgress } from "../../../course/progress.ts";

/** Tries after which fixes are offered in a task that asks for the fault. */
const TRIES = 3;

/** Whether fixes and slips are shown in a task that asks for the fault: after a hint, or a few tries. */
export const areFixesShown = ({ tries, hints, solution, passed }: TaskProgress): boolean =>
  passed !== null || solution || hints > 0 || tries >= TRIES;
