import type { Step } from "../../kernel/time/step.ts";
import type { Block } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";

/**
 * Comment that marks a cut below the contour of a cycle as intended: behind its block, or before the first block of the
 * cut.
 */
export const INTENDED_CUT = "INTENDED CUT";

const says = (comment: string | undefined): boolean =>
  comment !== undefined && comment.trim().toUpperCase().startsWith(INTENDED_CUT);

/** Blocks that form a cut. */
const CUTTING: ReadonlySet<Statement["kind"]> = new Set(["path", "free", "chamfer", "approach", "comment", "empty"]);

/** Whether a block continues the previous cut: a rapid or any other block ends it. */
const goesOn = ({ statement: s }: Block): boolean =>
  CUTTING.has(s.kind) && !(s.kind === "path" && s.words.feed === "max");

/** Index of the first block of a cut: a comment before it counts for the whole cut. */
export function startOfCut(blocks: readonly Block[], index: number): number {
  let begin = index;
  while (begin > 0 && goesOn(blocks[begin - 1] as Block)) begin -= 1;
  while (begin < index && blocks[begin]?.statement.kind !== "path") begin += 1;
  return begin;
}

const COMPENSATED = { intent: "compensated" } as const;
const SAID = { intent: "meant" } as const;
const NONE = {};

/** Whether a comment before the cut marks it as intended, up to its last block run. */
export interface CutIntent {
  readonly index: number;
  readonly isMeant: boolean;
}

/** The same at a block; `known`: at the previous block with a cut. */
export function cutIntentAt(blocks: readonly Block[], index: number, known: CutIntent | null): CutIntent {
  for (let i = index; i >= 0; i -= 1) {
    const block = blocks[i];
    if (!block || !goesOn(block)) break;
    if (known?.index === i) return { index, isMeant: known.isMeant };
    if (block.statement.kind === "comment" && says(block.statement.text)) return { index, isMeant: true };
  }
  return { index, isMeant: false };
}

/** Intent of the cut of a block. */
export function intentOf(
  blocks: readonly Block[],
  { index, isMeant }: CutIntent,
  isCompensated: boolean,
): Pick<Step, "intent"> {
  if (isMeant || says(blocks[index]?.comment)) return SAID;
  return isCompensated ? COMPENSATED : NONE;
}
