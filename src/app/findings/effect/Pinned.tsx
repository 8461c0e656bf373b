import { useOutcome } from "../../calculation/outcome.ts";
import { lazyPart } from "../../base/parts.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { setPinned, useCompared } from "./compared.ts";

/** Fetched when a setting is pinned. */
const PinnedValues = lazyPart(async () => ({ default: (await import("./PinnedValues.tsx")).PinnedValues }));

/** Pins the present setting as a reference. */
export function PinButton() {
  const { pin: t } = useTexts().page.effect;
  const pinned = useCompared((c) => c.pinned !== null);
  const ready = useOutcome((s) => s.newest !== null && !s.dimmed);
  return (
    <button
      type="button"
      className="button small pin"
      aria-pressed={pinned}
      disabled={!pinned && !ready}
      onClick={() => setPinned(!pinned)}
    >
      {t.make}
    </button>
  );
}

/** Two settings side by side, as long as one is pinned. */
export function PinnedCard() {
  const pinned = useCompared((c) => c.pinned !== null);
  return pinned && <PinnedValues />;
}
