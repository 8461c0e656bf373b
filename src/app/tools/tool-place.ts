import { create } from "zustand";
import { readTools, useTools } from "./tool-store.ts";

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

/** Shows the table with the row of a tool. */
export function showToolNumber(number: number): void {
  const { list } = useTools.getState();
  const { rows } = readTools(list);
  showTools(list.find((entry) => rows.get(entry.id)?.number === number)?.id);
}
