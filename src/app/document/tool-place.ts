import { create } from "zustand";
import { toolsOnDevice, useTools } from "./tool-store.ts";

export type ToolKind = "turning" | "milling";

/** Whether the tool table is shown in place of the work, and which of its rows is open. Undo does not touch it. */
export interface ToolPlace {
  readonly shown: boolean;
  /** Id of the open row; a row that is gone counts as the first one of its kind. */
  readonly row: string | null;
  /** The kind of tools that is shown while no row is open. */
  readonly kind: ToolKind;
}

export const useToolPlace = create<ToolPlace>(() => ({ shown: false, row: null, kind: "turning" }));

export const showTools = (row?: string): void => useToolPlace.setState((p) => ({ shown: true, row: row ?? p.row }));
export const hideTools = (): void => useToolPlace.setState({ shown: false });
export const openRow = (row: string | null): void => useToolPlace.setState({ row });

/** Shows the table with the row of a tool. */
export function showToolNumber(number: number): void {
  const { list } = useTools.getState();
  const { rows } = toolsOnDevice(list);
  showTools(list.find((entry) => rows.get(entry.id)?.number === number)?.id);
}

/** Shows the tools of a kind, the first of them open. */
export const showKind = (kind: ToolKind): void => useToolPlace.setState({ kind, row: null });
