import { actionSources } from "./actions/index.ts";
import type { ActionSource, PlanRequest } from "./types.ts";
import type { PlanChanges, PlanProgress, WorkingPlan } from "./working-plan.ts";

/**
 * Searches the working plan with the least time that leaves nothing a tool of the shop could take. Yields after every
 * few tries; to cancel, stop asking. Pure and deterministic: the same request gives the same plan.
 */
// eslint-disable-next-line require-yield
export function* planning(
  _request: PlanRequest,
  _changes: PlanChanges = {},
  _sources: readonly ActionSource[] = actionSources,
): Generator<PlanProgress, WorkingPlan> {
  throw new Error("not yet");
}
