import { KEY_PLACES } from "../../base/key-list.ts";
import { showKeys, usePlace } from "../../place/place.ts";

/** Controls in which a question mark is text. No value of a prompt has one. */
const TYPED_INTO = "input:not([type=radio], [type=checkbox], .value), select, textarea, [contenteditable=true]";

/** A question mark outside of a field opens the sheet of shortcuts at the place that has the focus (`data-keys`). */
export function onKeysKey(event: KeyboardEvent): void {
  const { key, target } = event;
  if (key !== "?" || event.ctrlKey || event.metaKey || event.altKey || usePlace.getState().over) return;
  if (!(target instanceof Element) || target.closest(`dialog, ${TYPED_INTO}`)) return;
  const at = target.closest<HTMLElement>("[data-keys]")?.dataset["keys"];
  event.preventDefault();
  showKeys(KEY_PLACES.find((place) => place === at) ?? "everywhere");
}
