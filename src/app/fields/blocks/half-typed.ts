import type { Program } from "../../../nc/program.ts";
import type { Draft } from "../../../program/job/read-draft.ts";
import { holdPicture } from "../../calculation/outcome.ts";
import { readingOfBlock } from "./block-prompts.ts";
import { cursorBlock, readingField } from "./reading-field.ts";
import type { TextUpdate } from "./text-view.ts";
import { rememberingLast } from "../../base/once.ts";

/*
 * A number of which one digit is typed is no value yet, or a wrong one, and what comes behind it in the program would
 * be run as if the operation were not there. A block that was right keeps its last good picture until it is right
 * again, or until somebody leaves it.
 */

/** The block that was right and is not, by its index; null while there is none. */
let half: number | null = null;

function isWrongWith(program: Program, index: number, draft: Draft): boolean {
  const block = program.blocks[index],
    read = readingOfBlock(program, index, draft);
  return (block !== undefined && block.issues.length > 0) || (read !== null && read.reading.values === null);
}

/** Whether a block cannot be run as its text stands. */
const isWrong = rememberingLast((program: Program, index: number): boolean => isWrongWith(program, index, {}));

function note(index: number | null): void {
  half = index;
  holdPicture(index !== null);
}

/** Another text is open, or none. */
export const forgetHalf = (): void => note(null);

/** Looks at a change of the text, before the changed text is run. */
export function watchText({ startState, state, docChanged }: TextUpdate): void {
  const index = cursorBlock(state);
  if (!docChanged) {
    if (half !== null && index !== half) note(null);
    return;
  }
  const wasRight = half !== null || !isWrong(startState.field(readingField).program, cursorBlock(startState));
  note(wasRight && isWrong(state.field(readingField).program, index) ? index : null);
}

/** Looks at what is typed into prompts; `program`: the text of their block, which has what can be read of them. */
export function watchTyped(program: Program, index: number, isWrongTyped: boolean): void {
  if (half === null && isWrong(program, index)) return;
  note(isWrongTyped ? index : null);
}

/** The same of the prompts of a cycle. */
export const watchDraft = (program: Program, index: number, draft: Draft): void =>
  watchTyped(program, index, isWrongWith(program, index, draft));
