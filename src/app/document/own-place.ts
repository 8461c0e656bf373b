import { create } from "zustand";
import { showSection, usePlace } from "../place/place.ts";
import { useEditor } from "./store.ts";
import { hideTools } from "./tool-place.ts";

/** Whether the list of own cycles is shown in place of the work, and which of them is open. Undo does not touch it. */
export interface OwnPlace {
  readonly shown: boolean;
  /** Id of the open description; one that is gone counts as the first. */
  readonly row: string | null;
  /** Counts up each time the first field of the open description should take the keyboard. */
  readonly focus: number;
}

export const useOwnPlace = create<OwnPlace>(() => ({ shown: false, row: null, focus: 0 }));

/** A program comes back with the block that was open. */
function keepBlock(): void {
  if (useEditor.getState().program && usePlace.getState().section === "prompts") showSection("block");
}

export function showOwn(row?: string, fields = false): void {
  keepBlock();
  hideTools();
  useOwnPlace.setState((p) => ({ shown: true, row: row ?? p.row, focus: fields ? p.focus + 1 : p.shown ? p.focus : 0 }));
}
export const hideOwn = (): void => useOwnPlace.setState({ shown: false });
export const openOwn = (row: string | null, fields = false): void =>
  useOwnPlace.setState((p) => ({ row, focus: fields ? p.focus + 1 : p.focus }));
