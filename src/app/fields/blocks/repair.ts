import { withInserted } from "../../../nc/edit.ts";
import { statementLines } from "../../../nc/print.ts";
import type { Program } from "../../../nc/program.ts";
import { styleAt } from "../../../nc/read-style.ts";
import type { Statement } from "../../../nc/statement.ts";

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

/** Inserts blocks at a place, in the style of the block that a finding belongs to; the last one opens. */
export function insertion(program: Program, at: number, statements: readonly Statement[], index: number): Repair {
  const style = styleAt(program, Math.max(0, Math.min(index, program.blocks.length - 1)));
  const text = statementLines(statements.at(-1) ?? { kind: "empty" }, style)[0] ?? "";
  return {
    kind: "insert",
    text: text.trim(),
    block: "",
    open: at + statements.length - 1,
    next: () => statements.reduce((made, statement, i) => withInserted(made, at + i, statement), program),
  };
}
