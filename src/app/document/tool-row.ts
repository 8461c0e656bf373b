import type { ToolEntry } from "../../program/tools/tool-entry.ts";
import { freeNumber, newId } from "../../program/tools/tool-list.ts";
import { showTools } from "../place/place.ts";
import { editTools, toolsOnDevice, useTools } from "./tool-store.ts";

/** Shows the tool table with the row of a tool. */
export function showToolNumber(number: number): void {
  const { list } = useTools.getState();
  const { rows } = toolsOnDevice(list);
  showTools(list.find((entry) => rows.get(entry.id)?.number === number)?.id);
}

/** Adds a row to the tool table of this device; returns its id. */
export function addToolRow(cells: ToolEntry["cells"]): string {
  const id = newId(useTools.getState().list);
  editTools((list) => [...list, { id, cells }]);
  return id;
}

/** Cells of a new turning tool. */
export const NEW_TOOL = { TYPE: "ROUGH", TO: "1" } as const;

/** Adds a turning tool for a called number or name, and shows it. */
export function createCalledTool(called: string): void {
  const isNumber = /^\d+$/.test(called);
  const T = isNumber ? called : String(freeNumber(useTools.getState().list));
  showTools(addToolRow({ T, ...(isNumber ? {} : { NAME: called }), ...NEW_TOOL }));
}
