import { create } from "zustand";
import type { Pt, Ring } from "../../../kernel/geometry/point.ts";
import type { PicturePlace } from "./places.ts";

/** Marks of a task in the picture, instead of the findings; a click may name a place. */
export interface TaskMarks {
  readonly places: readonly PicturePlace[];
  /** Missing and residual material, in part space. */
  readonly missing: readonly Ring[];
  readonly left: readonly Ring[];
  /** Called with a clicked place; null if a click chooses a move as usual. */
  readonly onPoint: ((place: Pt) => void) | null;
}

/** Null if no task has marks. */
export const useTaskMarks = create<{ readonly told: TaskMarks | null }>(() => ({ told: null }));
