import type { Step } from "../../kernel/time/step.ts";
import type { Block } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";

/**
 * What a comment says of a cut below the contour of a cycle: it is meant. Behind its block, or before the first block
 * of the cut.
 */
export const MEANT = "INTENDED CUT";

const says = (comment: string | null): boolean => comment !== null && comment.trim().toUpperCase().startsWith(MEANT);

/** Blocks of which a cut is made. */
const CUTTING: ReadonlySet<Statement["kind"]> = new Set(["path", "free", "chamfer", "approach", "comment", "empty"]);

/**
 * Whether a block goes on with the cut that the one before it has begun: a rapid ends it, and so does anything else.
 */
const goesOn = ({ statement: s }: Block): boolean =>
  CUTTING.has(s.kind) && !(s.kind === "path" && s.words.feed === "max");

/** Index of the first block of the cut that a block belongs to: a comment in front of it counts for the whole of it. */
export function beginOfCut(blocks: readonly Block[], index: number): number {
  let begin = index;
  while (begin > 0 && goesOn(blocks[begin - 1] as Block)) begin -= 1;
  while (begin < index && blocks[begin]?.statement.kind !== "path") begin += 1;
  return begin;
}

const COMPENSATED = { intent: "compensated" } as const;
const SAID = { intent: "meant" } as const;
const NONE = {};

/** Tells of blocks that cut, in the order in which they run, what is meant with their cut. */
export function intents(): (blocks: readonly Block[], index: number, isCompensated: boolean) => Pick<Step, "intent"> {
  let known: { readonly index: number; readonly said: boolean } | null = null;
  function isSaid(blocks: readonly Block[], index: number): boolean {
    for (let i = index; i >= 0; i -= 1) {
      const block = blocks[i];
      if (!block || !goesOn(block)) return false;
      if (known?.index === i) return known.said;
      if (block.statement.kind === "comment" && says(block.statement.text)) return true;
    }
    return false;
  }
  return (blocks, index, isCompensated) => {
    known = { index, said: isSaid(blocks, index) };
    if (known.said || says(blocks[index]?.comment ?? null)) return SAID;
    return isCompensated ? COMPENSATED : NONE;
  };
}
