import { useOutcome } from "../../calculation/outcome.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Label over a dimmed picture. */
export function Outdated() {
  const t = useTexts().lathe;
  const isBeginning = useOutcome((s) => s.pictured?.isBeginning ?? false);
  return <p className="lathe-outdated small">{isBeginning ? t.beginning : t.outdated}</p>;
}
