import type { Program } from "../../../nc/program.ts";

/** A change of the program that mends a finding: a value taken, a block put in, a word written, something taken out. */
export interface Repair {
  readonly kind: "take" | "insert" | "write" | "remove" | "tie" | "meant";
  /** The value, the block or the word, as the program writes it; a value as a number. */
  readonly text: string | number;
  /** Number of the block that is changed. */
  readonly block: string;
  readonly next: () => Program;
  /** Index of the block that opens afterwards. */
  readonly open: number;
  /** Its values are only a beginning: its dialog opens. */
  readonly asks?: boolean;
}
