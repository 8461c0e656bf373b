import { create } from "zustand";
import type { Pt, Ring } from "../../../kernel/geometry/point.ts";
import type { LookAt } from "./places.ts";

/** What a task shows in the picture in place of the findings, and whether a press there names a place. */
export interface ToldPicture {
  readonly places: readonly LookAt[];
  /** What is missing, and what was left, in part space. */
  readonly missing: readonly Ring[];
  readonly left: readonly Ring[];
  /** Takes a place that was pointed at; null where a press chooses a move, as ever. */
  readonly take: ((place: Pt) => void) | null;
}

/** Null where no task has anything to show. */
export const useTold = create<{ readonly told: ToldPicture | null }>(() => ({ told: null }));
