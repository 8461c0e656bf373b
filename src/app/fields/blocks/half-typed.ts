import type { Program } from "../../../nc/program.ts";
import type { Draft } from "../../../program/job/read-draft.ts";
import { holdPicture } from "../../calculation/outcome.ts";
import { readingOfBlock } from "./block-prompts.ts";
import { cursorBlock, readingField } from "./reading-field.ts";
import type { TextUpdate } from "./text-view.ts";
import { rememberingLast } from "../../base/once.ts";

/*
 * While a number is typed it is briefly missing or wrong, and the blocks after it would run as if the operation did not
 * exist. So a block that was valid keeps its last valid picture until it is valid again or is left.
 */

/** Index of the block that became invalid while typing; null if there is none. */
let halfTypedBlock: number | null = null;

function isWrongWith(program: Program, index: number, draft: Draft): boolean {
  const block = program.blocks[index],
    read = readingOfBlock(program, index, draft);
  return block?.issues !== undefined || (read !== null && read.reading.values === null);
}

/** True if the text of a block cannot be run. */
const isWrong = rememberingLast((program: Program, index: number): boolean => isWrongWith(program, index, {}));

function setHalfTyped(index: number | null): void {
  halfTypedBlock = index;
  holdPicture(index !== null);
}

/** Called when another text opens, or none. */
export const forgetHalfTyped = (): void => setHalfTyped(null);

/** Checks a change of the text before that text is run. */
export function watchText({ startState, state, docChanged }: TextUpdate): void {
  const index = cursorBlock(state);
  if (!docChanged) {
    if (halfTypedBlock !== null && index !== halfTypedBlock) setHalfTyped(null);
    return;
  }
  const wasRight = halfTypedBlock !== null || !isWrong(startState.field(readingField).program, cursorBlock(startState));
  setHalfTyped(wasRight && isWrong(state.field(readingField).program, index) ? index : null);
}

/** Checks what is typed into prompts. `program`: the text of their block, with all values that can be read. */
export function watchTyped(program: Program, index: number, isWrongTyped: boolean): void {
  if (halfTypedBlock === null && isWrong(program, index)) return;
  setHalfTyped(isWrongTyped ? index : null);
}

/** Checks the typed prompts of a cycle. */
export const watchDraft = (program: Program, index: number, draft: Draft): void =>
  watchTyped(program, index, isWrongWith(program, index, draft));
