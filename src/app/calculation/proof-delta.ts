import type { Run } from "../../program/state/run-types.ts";
import type { Checkpoint, Simulation } from "../../sim/simulation.ts";

/** A simulation without what the page already has: its run, and the first checkpoints of the previous one. */
export interface ProofDelta extends Omit<Simulation, "blank" | "steps"> {
  /** Number of checkpoints of the previous simulation that are reused, in front of those that are sent. */
  readonly kept: number;
}

/**
 * The part of a simulation to send to a page that has the previous checkpoints: unchanged checkpoints are identical
 * objects.
 */
export function proofDelta(
  { blank: _, steps: __, checkpoints, ...rest }: Simulation,
  before: readonly Checkpoint[],
): ProofDelta {
  const changed = checkpoints.findIndex((mark, i) => mark !== before[i]);
  const kept = changed < 0 ? checkpoints.length : changed;
  return { ...rest, kept, checkpoints: checkpoints.slice(kept) };
}

/** Restores the whole simulation from the run and the checkpoints that the page has. */
export const simulationOf = (
  { kept, checkpoints, ...rest }: ProofDelta,
  { blank, steps }: Pick<Run, "blank" | "steps">,
  before: { readonly simulation: Pick<Simulation, "checkpoints"> } | null,
): Simulation => ({
  ...rest,
  checkpoints: [...(before?.simulation.checkpoints.slice(0, kept) ?? []), ...checkpoints],
  blank,
  steps,
});
