import type { Situation } from "./situation.ts";

/** A set-up that broke a law, stored in found/: small, and tried in every test run. */
export interface FoundCase {
  readonly cycle: number;
  /** The messages of the laws at that time. */
  readonly said: readonly string[];
  readonly situation: Situation;
}
