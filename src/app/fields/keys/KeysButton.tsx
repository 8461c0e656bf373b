import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useFingers } from "../../base/use-media.ts";
import { showKeys } from "../../place/place.ts";
import type { KeyPlace } from "../../base/key-list.ts";

/**
 * Opens the sheet of shortcuts at a place; not shown on touch screens. Tab passes it by, as the question mark opens the
 * same sheet.
 */
export function KeysButton({ place }: { readonly place: KeyPlace }) {
  const { keys } = useTexts("first").page;
  const fingers = useFingers();
  if (fingers) return null;
  return (
    <button
      type="button"
      tabIndex={-1}
      className="button icon plain keys-button"
      aria-label={keys}
      title={`${keys} (?)`}
      aria-haspopup="dialog"
      onClick={() => showKeys(place)}
    >
      <Icon name="question" />
    </button>
  );
}
