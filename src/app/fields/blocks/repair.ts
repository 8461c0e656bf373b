import type { Program } from "../../../nc/program.ts";

/** A change that fixes a finding: sets a value, inserts a block, writes a word or removes something. */
export interface Repair {
  readonly kind: "take" | "insert" | "write" | "remove" | "tie" | "meant" | "runOut" | "endThread" | "relief";
  /** The value, the block or the word, as the program writes it; a value as a number. */
  readonly text: string | number;
  /** Number of the block that is changed. */
  readonly block: string;
  readonly next: () => Program;
  /** Index of the block that opens afterwards. */
  readonly open: number;
  /**
   * Only a run shows whether it helps. Of those with the same name, the first that does is offered.
   */
  readonly trial?: string;
  /** Its values are placeholders, so its dialog opens. */
  readonly asks?: boolean;
}
