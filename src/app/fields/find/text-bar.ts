import { useState } from "react";
import { useActions, type Action } from "../../base/actions.ts";

/** What the bar above a program text does. */
export type BarMode = "find" | "replace" | "goTo";

/** The bar above a program text, with the last search. */
export interface TextBar {
  /** Null while it is closed. */
  readonly mode: BarMode | null;
  /** Counts the openings: each focuses the field again. */
  readonly opened: number;
  /** The next (1) or previous (-1) occurrence is shown at once. */
  readonly step: -1 | 0 | 1;
  readonly sought: string;
  readonly replacement: string;
  readonly open: (mode: BarMode, step?: -1 | 1) => void;
  readonly search: (sought: string) => void;
  readonly replaceWith: (replacement: string) => void;
  readonly close: () => void;
}

type BarState = Pick<TextBar, "mode" | "opened" | "step" | "sought" | "replacement">;

/** Longest selection that becomes the searched text. */
const LONGEST_SELECTION = 80;

interface Opening {
  readonly modes: readonly BarMode[];
  /** Brings the text into view. */
  readonly show?: () => void;
  /** What is selected in the text: it is searched. */
  readonly selected?: () => string;
}

/** The bar of a text, and its shortcuts. */
export function useTextBar({ modes, show, selected }: Opening): TextBar {
  const [bar, set] = useState<BarState>({ mode: null, opened: 0, step: 0, sought: "", replacement: "" });
  const open = (mode: BarMode, step: -1 | 0 | 1 = 0) => {
    const text = step === 0 && mode !== "goTo" ? (selected?.() ?? "") : "";
    const isSearched = text.trim() !== "" && !text.includes("\n") && text.length <= LONGEST_SELECTION;
    show?.();
    set((now) => ({ ...now, mode, step, opened: now.opened + 1, sought: isSearched ? text : now.sought }));
  };
  const keys: readonly (Action & { readonly mode: BarMode })[] = [
    { mode: "find", id: "text.find", run: () => open("find") },
    { mode: "find", id: "text.next", isUnlisted: true, run: () => open("find", 1) },
    { mode: "find", id: "text.previous", isUnlisted: true, run: () => open("find", -1) },
    { mode: "replace", id: "text.replace", run: () => open("replace") },
    { mode: "goTo", id: "text.goTo", run: () => open("goTo") },
  ];
  useActions(keys.filter(({ mode }) => modes.includes(mode)));
  return {
    ...bar,
    open,
    search: (sought) => set((now) => ({ ...now, sought })),
    replaceWith: (replacement) => set((now) => ({ ...now, replacement })),
    close: () => set((now) => ({ ...now, mode: null })),
  };
}

/** Marks a program text with its bar: while the focus is in there, the cursor leads and the prompts follow. */
export const TEXT_AREA = "data-text-area";
export const isInTextArea = (): boolean => Boolean(document.activeElement?.closest(`[${TEXT_AREA}]`));
