import { parse } from "../../../nc/parse.ts";
import { blockNumbers, startLines } from "../../../nc/program.ts";
import { blockSpan } from "../../../program/run/block-span.ts";
import type { PathChoice } from "../../../program/run/path-index.ts";

/** What a block of a job's program stands for in the picture. */
export function choiceOfBlock(text: string, block: number): PathChoice | null {
  const program = parse(text);
  const index = blockNumbers(program).indexOf(block);
  return index < 0 ? null : { kind: "blocks", span: blockSpan(program, index), line: startLines(program)[index] ?? 0 };
}
