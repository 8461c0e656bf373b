import { freeNumber, newId } from "../../program/tools/tool-list.ts";
import { showTools } from "../place/place.ts";
import { editTools, toolsOnDevice, useTools } from "./tool-store.ts";

/** Shows the tool table with the row of a tool. */
export function showToolNumber(number: number): void {
  const { list } = useTools.getState();
  const { rows } = toolsOnDevice(list);
  showTools(list.find((entry) => rows.get(entry.id)?.number === number)?.id);
}

/** Adds a row for a called number or name to the tool table, and shows it. */
export function createCalledTool(called: string): void {
  const { list } = useTools.getState();
  const id = newId(list);
  const name = /^\d+$/.test(called) ? { T: called } : { T: String(freeNumber(list)), NAME: called };
  editTools(() => [...list, { id, cells: { ...name, TYPE: "ROUGH", TO: "1" } }]);
  showTools(id);
}
