import { create } from "zustand";
import type { RowField } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";

/** What the middle of the page shows while a contour is edited. */
export type ContourView = "draw" | "lathe";

/** A field of the table, by the id of its row. */
export interface BegunField {
  readonly row: string;
  readonly field: RowField;
}

/** State shared by drawing and table of a contour: not part of the work, so undo does not touch it. */
interface ContourPlace {
  readonly view: ContourView;
  /** Id of the chosen element. */
  readonly chosen: string | null;
  /** Counts up to move the focus to the selected row of the table. */
  readonly keyboard: number;
  /** The field of the table with a sign that was just typed, not left since. */
  readonly begun: BegunField | null;
}

export const useContourPlace = create<ContourPlace>(() => ({ view: "draw", chosen: null, keyboard: 0, begun: null }));

export const showContourView = (view: ContourView): void => useContourPlace.setState({ view });
export const chooseElement = (chosen: string | null): void => useContourPlace.setState({ chosen });
/** Selects an element and focuses its row. */
export const goToElement = (chosen: string | null): void =>
  useContourPlace.setState((p) => ({ chosen, keyboard: p.keyboard + 1 }));

/** Index of the selected element, by default the first one; null if there is none. */
export function useChosenRow(rows: readonly ContourRow[]): number | null {
  const chosen = useContourPlace((p) => p.chosen);
  const found = rows.findIndex((r) => r.id === chosen);
  return found >= 0 ? found : rows.length > 0 ? 0 : null;
}
