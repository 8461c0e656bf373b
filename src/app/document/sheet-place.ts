import { create } from "zustand";
import { useEditor } from "./store.ts";

/** The work whose setup sheet is shown in place of its workplace; null shows none. Undo does not touch it. */
export const useSheetPlace = create<{ readonly of: string | null }>(() => ({ of: null }));

export const showSheet = (): void => useSheetPlace.setState({ of: useEditor.getState().work });
export const hideSheet = (): void => useSheetPlace.setState({ of: null });

/** Whether the sheet of the open work is shown. */
export const useSheetShown = (): boolean => {
  const of = useSheetPlace((p) => p.of);
  return useEditor((s) => s.work !== null && s.work === of);
};

/** The same outside of components. */
export const sheetIsShown = (): boolean => {
  const { work } = useEditor.getState();
  return work !== null && useSheetPlace.getState().of === work;
};
