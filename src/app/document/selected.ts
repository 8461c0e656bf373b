import { create } from "zustand";
import type { PathChoice } from "../../program/run/path-index.ts";

/**
 * The last selection in the text, the picture or the contour table. The tool position belongs to the playback, and the
 * open prompt to the place; each selection leads both there.
 */
export interface Selection {
  /** The marked part of the path. */
  readonly choice: PathChoice | null;
  /** Selected before the first run: the tool goes there as soon as that is done. */
  readonly isEarly: boolean;
  /** The selected line of a job's program, and the prompt that was open then. */
  readonly line: { readonly block: number; readonly q: string | null; readonly prompt: string | null } | null;
}

export const NOTHING_SELECTED: Selection = { choice: null, isEarly: false, line: null };

export const useSelection = create<Selection>(() => NOTHING_SELECTED);

/** Clears the selection. */
export const clearSelection = (): void => useSelection.setState(NOTHING_SELECTED);
