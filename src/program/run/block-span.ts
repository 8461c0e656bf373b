import type { Program } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";

/** Blocks of a program by their indices, first and last included. */
export interface BlockSpan {
  readonly from: number;
  readonly to: number;
}

type Ends = (s: Statement) => boolean;

const closesLabel: Ends = (s) => s.kind === "label" && s.label === 0;
/** The end of a block's span: the next block of its kind. */
const NEXT_OF_KIND: Partial<Record<Statement["kind"], Ends>> = {
  toolCall: (s) => s.kind === "toolCall" || s.kind === "end",
  structure: (s) => s.kind === "structure" || s.kind === "end",
  label: closesLabel,
};

function spanFrom({ blocks }: Program, from: number, ends: Ends): BlockSpan {
  const end = blocks.findIndex(({ statement }, i) => i > from && ends(statement));
  return { from, to: (end < 0 ? blocks.length : end) - 1 };
}

/**
 * Blocks that a block represents: a tool call or structure item all up to the next one, a label or its call the
 * subprogram, any other block itself.
 */
export function blockSpan(program: Program, index: number): BlockSpan {
  const statement = program.blocks[index]?.statement;
  if (statement?.kind === "call") {
    const target = program.blocks.findIndex(({ statement: s }) => s.kind === "label" && s.label === statement.label);
    return target < 0 ? { from: index, to: index } : spanFrom(program, target, closesLabel);
  }
  const ends = statement && NEXT_OF_KIND[statement.kind];
  const alone = !ends || (statement.kind === "label" && statement.label === 0);
  return alone ? { from: index, to: index } : spanFrom(program, index, ends);
}
