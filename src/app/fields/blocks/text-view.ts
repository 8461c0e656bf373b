import type { EditorState, Transaction } from "@codemirror/state";
import { EditorView, type ViewUpdate } from "@codemirror/view";
import { behindTyping } from "../../base/typing.ts";

/** What has become of a text, in its editor or on the way there. */
export type TextUpdate = Pick<ViewUpdate, "state" | "startState" | "transactions" | "docChanged" | "selectionSet">;

/**
 * The editor of a text. What a dialog changes while somebody types there is in the text at once, and in the editor with
 * the next picture.
 */
export interface TextView {
  /** The editor, which knows the whole text. */
  readonly get: () => EditorView;
  /** What the editor is on the page. */
  readonly dom: HTMLElement;
  /** A change that a dialog makes of the newest state of the text. */
  readonly edit: (made: Transaction) => void;
  /** Shows another text. */
  readonly put: (state: EditorState) => void;
  readonly destroy: () => void;
}

/** Makes an editor. `onChange` is told of each change once, when it is made. */
export function createTextView(begin: EditorState, onChange: (change: TextUpdate) => void): TextView {
  let behind: readonly Transaction[] = [];
  const catchUp = () => {
    const due = behind;
    behind = [];
    if (due.length > 0) view.update(due);
  };
  const view = new EditorView({
    state: begin,
    dispatchTransactions(made) {
      // What an editor does by itself while it is behind was meant for an older text.
      if (behind.length > 0) return catchUp();
      view.update(made);
      onChange(changeOf(made));
    },
  });
  return {
    get() {
      catchUp();
      return view;
    },
    dom: view.dom,
    edit(made) {
      if (behindTyping(catchUp)) behind = [...behind, made];
      else {
        catchUp();
        view.update([made]);
      }
      onChange(changeOf([made]));
    },
    put(state) {
      behind = [];
      view.setState(state);
    },
    destroy: () => view.destroy(),
  };
}

function changeOf(made: readonly Transaction[]): TextUpdate {
  const [first, last] = [made[0], made.at(-1)];
  if (!first || !last) throw new Error("a text changes by transactions");
  return {
    state: last.state,
    startState: first.startState,
    transactions: made,
    docChanged: made.some((tr) => tr.docChanged),
    selectionSet: made.some((tr) => tr.selection !== undefined),
  };
}
