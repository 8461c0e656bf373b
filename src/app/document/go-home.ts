import { showEntrance, toFirstPrompt, type Entrance } from "../place/place.ts";
import { open, useEditor } from "./store.ts";

/** Shows an entrance page in place of the work. The work remains on the device, and undo opens it again. */
export function goToEntrance(entrance: Entrance): void {
  toFirstPrompt();
  if (useEditor.getState().work !== null) open(null, null);
  showEntrance(entrance);
}

export const goHome = (): void => goToEntrance({ page: "start" });
