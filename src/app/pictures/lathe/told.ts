import { create } from "zustand";
import type { Pt, Ring } from "../../../kernel/geometry/point.ts";
import type { LookAt } from "./places.ts";

/** Marks of a task in the picture, instead of the findings; a click may name a place. */
export interface ToldPicture {
  readonly places: readonly LookAt[];
  /** Missing and residual material, in part space. */
  readonly missing: readonly Ring[];
  readonly left: readonly Ring[];
  /** Called with a clicked place; null if a click chooses a move as usual. */
  readonly take: ((place: Pt) => void) | null;
}

/** Null if no task has marks. */
export const useTold = create<{ readonly told: ToldPicture | null }>(() => ({ told: null }));
