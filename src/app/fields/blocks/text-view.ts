import type { EditorState, Transaction } from "@codemirror/state";
import { EditorView, type ViewUpdate } from "@codemirror/view";
import { deferWhileTyping } from "../../base/typing.ts";

/** A change of a text, whether or not the editor shows it yet. */
export type TextUpdate = Pick<ViewUpdate, "state" | "startState" | "transactions" | "docChanged" | "selectionSet">;

/**
 * The editor of a text. A dialog's change while typing is in the text at once, and in the editor with the next frame.
 */
export interface TextView {
  /** The editor, updated to the newest text. */
  readonly get: () => EditorView;
  /** DOM element of the editor. */
  readonly dom: HTMLElement;
  /** Applies a dialog's change to the newest text state. */
  readonly edit: (made: Transaction) => void;
  /** Shows another text. */
  readonly put: (state: EditorState) => void;
  readonly destroy: () => void;
}

/**
 * Makes an editor whose styles are in a constructed sheet. CodeMirror makes one only where there is no head, and a style
 * element in the head would be blocked by the content policy. All later editors use the same sheet.
 */
function withConstructedSheet<T>(make: () => T): T {
  if (!("adoptedStyleSheets" in document)) return make();
  Object.defineProperty(document, "head", { configurable: true, value: null });
  try {
    return make();
  } finally {
    Reflect.deleteProperty(document, "head");
  }
}

/** Creates an editor. `onChange` is called once for each change, when it is made. */
export function createTextView(begin: EditorState, onChange: (change: TextUpdate) => void): TextView {
  let behind: readonly Transaction[] = [];
  const catchUp = () => {
    const due = behind;
    behind = [];
    if (due.length > 0) view.update(due);
  };
  const view = withConstructedSheet(
    () =>
      new EditorView({
        state: begin,
        dispatchTransactions(made) {
          // An editor that is behind acts on an older text, so its own changes are dropped.
          if (behind.length > 0) return catchUp();
          view.update(made);
          onChange(changeOf(made));
        },
      }),
  );
  return {
    get() {
      catchUp();
      return view;
    },
    dom: view.dom,
    edit(made) {
      if (deferWhileTyping(catchUp)) behind = [...behind, made];
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
