import { useMemo } from "react";
import { useOutcome } from "../../calculation/outcome.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { settingOf, useCompared, type MeasuredSetting } from "./compared.ts";
import { changeText, numberText, type ComparedNumber } from "./changes.ts";

/** Attributes that style sheets show beside a number: the previous value before it, or the difference after it. */
type Change = { readonly "data-was": string } | { readonly "data-by": string };

/** The two compared settings; null while one of them is not known. */
function useComparedSettings(): readonly [before: MeasuredSetting, now: MeasuredSetting] | null {
  const { before, pinned } = useCompared();
  const shown = useOutcome((s) => s.shown);
  const pictured = useOutcome((s) => s.pictured);
  const dimmed = useOutcome((s) => s.dimmed);
  const compared = pinned ?? before;
  return useMemo(() => {
    return compared && shown && pictured && !dimmed ? [compared, settingOf(shown, pictured)] : null;
  }, [compared, shown, pictured, dimmed]);
}

/** Changes of the present values against the pinned setting, or else the one when the open prompt was opened. */
export function useChanges(): { readonly changed: (name: ComparedNumber) => Change | null } {
  const t = useTexts();
  const lengths = useLengths();
  const both = useComparedSettings();
  return {
    changed(name) {
      const text = both && changeText(t, lengths, both[0], both[1], name);
      if (text === null) return null;
      return name === "time" ? { "data-by": text } : { "data-was": text };
    },
  };
}

/** Change of the number of gouges and collisions. */
export function FaultsChange() {
  const t = useTexts();
  const lengths = useLengths();
  const both = useComparedSettings();
  if (!both || changeText(t, lengths, both[0], both[1], "faults") === null) return null;
  const [was, is] = both.map((setting) => numberText(t, lengths, setting, "faults"));
  return (
    <span className="effect-was">
      {t.page.effect.faults}: {was} → {is}
    </span>
  );
}
