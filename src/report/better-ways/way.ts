import type { ChangeSubject } from "./change.ts";
import type { Gain, Measure } from "./measure.ts";

/** A change to try, as plain data: its text is the program that it would be. */
export interface Candidate {
  readonly subject: ChangeSubject;
  readonly text: string;
}

/** A change that was tried and is better. */
export interface BetterWay extends Candidate {
  readonly before: Measure;
  readonly after: Measure;
  readonly gains: readonly Gain[];
  /** s, to sort by. */
  readonly worth: number;
}
