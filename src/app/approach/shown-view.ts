import { create } from "zustand";
import type { Run } from "../../program/run-types.ts";

/** Which picture of a program that both turns and mills was asked for; null leaves it to the program. */
export const useAskedView = create<{ readonly asked: "lathe" | "plane" | null }>(() => ({ asked: null }));

type Paths = Pick<Run, "plane" | "steps" | "stepBlocks">;

/** True where the working plane is shown: what is milled cannot be seen in the section of the lathe. */
export const showsPlane = (run: Paths, asked: "lathe" | "plane" | null): boolean =>
  run.plane.length > 0 && (run.steps.length === 0 || asked === "plane");

/** The block that a step of the shown picture comes from, as its index in the program; null in an empty one. */
export function shownBlock(run: Paths, step: number): number | null {
  if (showsPlane(run, useAskedView.getState().asked)) return run.plane[Math.min(step, run.plane.length - 1)]?.index ?? null;
  return run.stepBlocks[Math.min(step, run.steps.length - 1)] ?? null;
}
