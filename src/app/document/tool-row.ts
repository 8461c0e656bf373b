import { showTools } from "../place/place.ts";
import { toolsOnDevice, useTools } from "./tool-store.ts";

/** Shows the tool table with the row of a tool. */
export function showToolNumber(number: number): void {
  const { list } = useTools.getState();
  const { rows } = toolsOnDevice(list);
  showTools(list.find((entry) => rows.get(entry.id)?.number === number)?.id);
}
