import { EditorView } from "@codemirror/view";
import type { SearchedText } from "../../app/fields/find/FindBar.tsx";
import { setSearch } from "../../app/fields/find/found-marks.ts";
import type { TextPlace } from "../../app/fields/find/text-places.ts";
import { unfolding } from "../../app/fields/blocks/folding.ts";
import { openBlock, readWhole, replaceText, sessionView } from "../../app/fields/blocks/session.ts";

/** Space kept above and below a place that is scrolled to, pixels. */
const SCROLL_MARGIN = 60;

const selection = () => sessionView()?.state.selection.main ?? { from: 0, to: 0 };

/** The selected text of the editor. */
export const selectedText = (): string => {
  const { from, to } = selection();
  return sessionView()?.state.sliceDoc(from, to) ?? "";
};

/** The text of the editor, for the bar that searches it. */
export const editorText: SearchedText = {
  text: () => sessionView()?.state.doc.toString() ?? "",
  selection,
  show(sought, match, isChosen) {
    if (match && isChosen) readWhole();
    const view = sessionView();
    view?.dispatch({
      effects: [
        setSearch.of({ sought, shown: match }),
        ...(match
          ? [
              ...unfolding(view.state, match.from, match.to),
              EditorView.scrollIntoView(match.from, { y: "nearest", yMargin: SCROLL_MARGIN }),
            ]
          : []),
      ],
      ...(match && isChosen && { selection: { anchor: match.from, head: match.to }, userEvent: "select.search" }),
    });
  },
  focus: () => sessionView()?.focus(),
  replace: replaceText,
};

/** Puts the cursor on a place. */
export function goToPlace({ index, q }: TextPlace): void {
  readWhole();
  openBlock(index, q);
  sessionView()?.focus();
}
