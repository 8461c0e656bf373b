import { create } from "zustand";
import type { PathChoice } from "../../program/run/path-index.ts";

/**
 * What was pointed at last, wherever that was: in the text, in the picture, in the contour table. Where the tool stands
 * is the playback's position, and which prompt is open is the place; each choice leads both there.
 */
export interface Selection {
  /** What is marked of the path. */
  readonly choice: PathChoice | null;
  /** It was chosen before anything of the work was run: the tool goes there with the first run. */
  readonly isEarly: boolean;
  /** The line of a job's program that was pointed at, and the prompt that was open then. */
  readonly line: { readonly block: number; readonly q: string | null; readonly prompt: string | null } | null;
}

export const NOTHING_SELECTED: Selection = { choice: null, isEarly: false, line: null };

export const useSelection = create<Selection>(() => NOTHING_SELECTED);

/** Nothing is chosen any more. */
export const clearSelection = (): void => useSelection.setState(NOTHING_SELECTED);
