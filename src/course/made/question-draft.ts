import type { Prediction } from "../task.ts";

/** What can be asked, in the order in which it is offered. */
export const ASKED_KINDS = [
  "passes",
  "infeed",
  "seconds",
  "residue",
  "diameter",
  "bore",
  "face",
  "residuePlace",
  "gougePlace",
  "rapidPlace",
  "choice",
  "block",
] as const satisfies readonly Prediction["ask"][];
export type AskedKind = (typeof ASKED_KINDS)[number];

/** A question as typed. */
export interface QuestionDraft {
  readonly ask: AskedKind;
  readonly text: string;
  /** Of passes, infeed, seconds and residue: the cycle call that is meant, from 0; null for all together. */
  readonly operation: number | null;
  /** Of a size: Z of a diameter, ⌀ of a face. */
  readonly at: string;
  readonly within: string;
  /** Of a choice: what is offered, a line each. Of both: the right one from 0, or the numbers of the right blocks. */
  readonly choices: string;
  readonly right: string;
}
