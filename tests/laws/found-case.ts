import type { Situation } from "./situation.ts";

/** A set-up that broke a law, as it lies in found/: small, and tried with every run of the tests. */
export interface FoundCase {
  readonly cycle: number;
  /** What the law said then. */
  readonly said: readonly string[];
  readonly situation: Situation;
}
