import type { Action } from "../../base/actions.ts";
import { KEY_PLACES } from "../../base/key-list.ts";
import { showCommands, showKeys } from "../../place/place.ts";

/** The command palette, and the sheet of shortcuts at the place that has the focus (`data-keys`). */
export const PAGE_ACTIONS: readonly Action[] = [
  { id: "everywhere.commands", isUnlisted: true, run: showCommands },
  {
    id: "everywhere.keys",
    run() {
      const at = document.activeElement?.closest<HTMLElement>("[data-keys]")?.dataset["keys"];
      showKeys(KEY_PLACES.find((place) => place === at) ?? "everywhere");
    },
  },
];
