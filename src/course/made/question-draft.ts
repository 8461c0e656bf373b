import type { TaskPrediction } from "../task.ts";
import type { InLanguages } from "../words.ts";

/** The kinds of questions, in the order of the menu. */
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
] as const satisfies readonly TaskPrediction["ask"][];
export type AskedKind = (typeof ASKED_KINDS)[number];

/** A question as typed. */
export interface QuestionDraft {
  readonly ask: AskedKind;
  readonly text: string;
  /** For passes, infeed, seconds and residue: the cycle call, from 0; null for all calls together. */
  readonly operation: number | null;
  /** For a size: Z of a diameter, ⌀ of a face. */
  readonly at: string;
  readonly within: string;
  /** For a choice: the options, one per line. For both: the right option from 0, or the numbers of the right blocks. */
  readonly choices: string;
  readonly right: string;
  /** Wording and choices in further languages. */
  readonly translations?: InLanguages<Pick<QuestionDraft, "text" | "choices">> | undefined;
}
