import { parse } from "../../../nc/parse.ts";
import { blockNumbers, startLines } from "../../../nc/program.ts";
import { blockSpan } from "../../../program/run/block-span.ts";
import type { PathChoice } from "../../../program/run/path-index.ts";

/** Path of a block in the program of a job. */
export function choiceOfBlock(text: string, block: number): PathChoice | null {
  const program = parse(text);
  const index = blockNumbers(program).indexOf(block);
  return index < 0 ? null : { kind: "blocks", span: blockSpan(program, index), line: startLines(program)[index] ?? 0 };
}
