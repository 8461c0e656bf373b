import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useFingers } from "../../base/use-media.ts";
import { showKeys } from "../../place/place.ts";
import type { KeyPlace } from "../../base/key-list.ts";

/** Opens the sheet of shortcuts at a place; not shown on touch screens. */
export function KeysButton({ place }: { readonly place: KeyPlace }) {
  const { keys } = useTexts("first").page;
  const fingers = useFingers();
  if (fingers) return null;
  return (
    <button
      type="button"
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
