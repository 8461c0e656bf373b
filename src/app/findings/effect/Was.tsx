import { useMemo } from "react";
import { useOutcome } from "../../calculation/outcome.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { settingOf, useCompared, type MeasuredSetting } from "./before.ts";
import { changeText, numberText, type ComparedNumber } from "./changes.ts";

/** What style sheets write beside a number: what it was in front of it, by how much it changed behind it. */
type Change = { readonly "data-was": string } | { readonly "data-by": string };

/** The two settings that are compared; null while one of them is not known. */
function useBoth(): readonly [before: MeasuredSetting, now: MeasuredSetting] | null {
  const { before, pinned } = useCompared();
  const shown = useOutcome((s) => s.shown);
  const pictured = useOutcome((s) => s.pictured);
  const dimmed = useOutcome((s) => s.dimmed);
  const compared = pinned ?? before;
  return useMemo(() => {
    return compared && shown && pictured && !dimmed ? [compared, settingOf(shown, pictured)] : null;
  }, [compared, shown, pictured, dimmed]);
}

/**
 * What the present values have changed, against the pinned setting, or else the one at which the open prompt opened.
 */
export function useChanges(): { readonly changed: (name: ComparedNumber) => Change | null } {
  const t = useTexts();
  const lengths = useLengths();
  const both = useBoth();
  return {
    changed(name) {
      const text = both && changeText(t, lengths, both[0], both[1], name);
      if (text === null) return null;
      return name === "time" ? { "data-by": text } : { "data-was": text };
    },
  };
}

/** Gouges and collisions that the present values have made or taken away. */
export function MoreFaults() {
  const t = useTexts();
  const lengths = useLengths();
  const both = useBoth();
  if (!both || changeText(t, lengths, both[0], both[1], "faults") === null) return null;
  const [was, is] = both.map((setting) => numberText(t, lengths, setting, "faults"));
  return (
    <span className="effect-was">
      {t.page.effect.faults}: {was} → {is}
    </span>
  );
}
