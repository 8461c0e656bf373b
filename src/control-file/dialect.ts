import type { FileLine } from "./file-lines.ts";
import type { LineCursor } from "./line-cursor.ts";
import type { LineRefusal } from "./refusal.ts";

/** A label that a block sets. */
export interface LabelSet {
  /** As written, with its quotation marks when it is a name. */
  readonly label: string;
  readonly at: number;
}

/** One of the two languages of program files. The cursor of each function stands at the first word of a block. */
export interface Dialect {
  /** The letter in front of a block number. */
  readonly letter: "" | "N";
  /** Whether blocks end in `*`. */
  readonly star: boolean;
  readonly units: readonly string[];
  /**
   * Whether the block begins or ends the program; the cursor is then behind its words. `isBegun`: the program has
   * begun.
   */
  frame(cursor: LineCursor, isBegun: boolean): "begin" | "end" | null;
  /** Words that open a list of Q parameters; empty for any other block. */
  listOpener(cursor: LineCursor): string;
  /** The first fault of a block, or of the head of a list. */
  checkBlock(cursor: LineCursor): LineRefusal | null;
  labelSet(cursor: LineCursor): LabelSet | null;
  /** Whether a line opens a block of its own. */
  opensBlock(line: FileLine): boolean;
}
