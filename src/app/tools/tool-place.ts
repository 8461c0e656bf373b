import { create } from "zustand";

/** Whether the tool table is shown in place of the work, and which of its rows is open. Undo does not touch it. */
export interface ToolPlace {
  readonly shown: boolean;
  /** Id of the open row; a row that is gone counts as the first one. */
  readonly row: string | null;
}

export const useToolPlace = create<ToolPlace>(() => ({ shown: false, row: null }));

export const showTools = (row?: string): void => useToolPlace.setState((p) => ({ shown: true, row: row ?? p.row }));
export const hideTools = (): void => useToolPlace.setState({ shown: false });
export const openRow = (row: string | null): void => useToolPlace.setState({ row });
