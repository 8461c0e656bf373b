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
let half: number | null = null;

function isWrongWith(program: Program, index: number, draft: Draft): boolean {
  const block = program.blocks[index],
    read = readingOfBlock(program, index, draft);
  return (block !== undefined && block.issues.length > 0) || (read !== null && read.reading.values === null);
}

/** True if the text of a block cannot be run. */
const isWrong = rememberingLast((program: Program, index: number): boolean => isWrongWith(program, index, {}));

function note(index: number | null): void {
  half = index;
  holdPicture(index !== null);
}

/** Called when another text opens, or none. */
export const forgetHalf = (): void => note(null);

/** Checks a change of the text before that text is run. */
export function watchText({ startState, state, docChanged }: TextUpdate): void {
  const index = cursorBlock(state);
  if (!docChanged) {
    if (half !== null && index !== half) note(null);
    return;
  }
  const wasRight = half !== null || !isWrong(startState.field(readingField).program, cursorBlock(startState));
  note(wasRight && isWrong(state.field(readingField).program, index) ? index : null);
}

/** Checks what is typed into prompts. `program`: the text of their block, with all values that can be read. */
export function watchTyped(program: Program, index: number, isWrongTyped: boolean): void {
  if (half === null && isWrong(program, index)) return;
  note(isWrongTyped ? index : null);
}

/** Checks the typed prompts of a cycle. */
export const watchDraft = (program: Program, index: number, draft: Draft): void =>
  watchTyped(program, index, isWrongWith(program, index, draft));
