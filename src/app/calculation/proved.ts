import type { Run } from "../../program/state/run-types.ts";
import type { Checkpoint, Simulation } from "../../sim/simulation.ts";

/** A simulation without what the page has of it: its run, and the first marks of the one before. */
export interface Proved extends Omit<Simulation, "blank" | "steps"> {
  /** How many of the marks before are marks of this one, and stand before those that are sent. */
  readonly kept: number;
}

/**
 * What is sent of a simulation to a page that has the marks of the one before: unchanged marks are the very same
 * objects.
 */
export function provedBeside(
  { blank: _, steps: __, checkpoints, ...rest }: Simulation,
  before: readonly Checkpoint[],
): Proved {
  const changed = checkpoints.findIndex((mark, i) => mark !== before[i]);
  const kept = changed < 0 ? checkpoints.length : changed;
  return { ...rest, kept, checkpoints: checkpoints.slice(kept) };
}

/** The whole of it again, with the run and the marks that the page has. */
export const simulationOf = (
  { kept, checkpoints, ...rest }: Proved,
  { blank, steps }: Pick<Run, "blank" | "steps">,
  before: { readonly simulation: Pick<Simulation, "checkpoints"> } | null,
): Simulation => ({
  ...rest,
  checkpoints: [...(before?.simulation.checkpoints.slice(0, kept) ?? []), ...checkpoints],
  blank,
  steps,
});
