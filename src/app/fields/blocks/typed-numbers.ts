import { Transaction, type EditorState } from "@codemirror/state";
import { withNumbers } from "../../../nc/edit.ts";
import { blockAt, type Reading } from "../../../nc/reread.ts";
import { changesBetween, type TextChange } from "./block-edits.ts";
import { readingField } from "./reading-field.ts";
import type { TextUpdate } from "./text-view.ts";

/** Ways of entering text that write blocks; undo and dialogs number by themselves. */
const TYPED = ["input.type", "input.paste", "input.drop", "input.complete"];

const isTyped = ({ transactions }: TextUpdate): boolean =>
  transactions.some((tr) => {
    // A new line is an input without a kind of its own.
    const isNewLine = tr.annotation(Transaction.userEvent) === "input";
    return tr.docChanged && (isNewLine || TYPED.some((event) => tr.isUserEvent(event)));
  });

/** A parameter that is being typed behind a cycle: it may still become a line of that list. */
function mayJoinCycle({ program: { blocks } }: Reading, index: number): boolean {
  const before = blocks.slice(0, index).findLast(({ statement }) => statement.kind !== "empty");
  return before?.statement.kind === "cycle" && /^\s*Q/i.test(blocks[index]?.raw ?? "");
}

/** The blocks that a change touched, by index. */
function touchedBlocks(state: EditorState, { transactions }: TextUpdate): readonly [first: number, last: number] {
  let [from, to] = [Infinity, 0];
  for (const tr of transactions)
    tr.changes.iterChangedRanges((_, __, a, b) => {
      from = Math.min(from, a);
      to = Math.max(to, b);
    });
  const reading = state.field(readingField);
  return [blockAt(reading, from), blockAt(reading, to)];
}

/** Most changes that stay single: each costs the editor more than the text up to the next one. */
const SINGLE = 2000;

/** Many changes as one, with the text between them. */
function joined({ doc }: EditorState, changes: readonly TextChange[]): readonly TextChange[] {
  const [first, last] = [changes[0], changes.at(-1)];
  if (changes.length <= SINGLE || !first || !last) return changes;
  const insert = changes.map((each, i) => each.insert + doc.sliceString(each.to, changes[i + 1]?.from ?? each.to));
  return [{ from: first.from, to: last.to, insert: insert.join("") }];
}

/**
 * What numbers the blocks that were just typed: in a numbered program a block has its number from its first letter on.
 */
export function numberTyped(update: TextUpdate): readonly TextChange[] {
  const { state } = update;
  if (!update.docChanged || !isTyped(update)) return [];
  const reading = state.field(readingField);
  const [first, last] = touchedBlocks(state, update);
  const isOpen = last === blockAt(reading, state.selection.main.head) && mayJoinCycle(reading, last);
  const { program } = reading;
  const changes = changesBetween(program, withNumbers(program, first, isOpen ? last - 1 : last));
  const { head } = state.selection.main;
  const after = changes.findIndex(({ from }) => from >= head);
  const at = after < 0 ? changes.length : after;
  // The cursor stays where it is in the text: no change goes over it.
  return [...joined(state, changes.slice(0, at)), ...joined(state, changes.slice(at))];
}
