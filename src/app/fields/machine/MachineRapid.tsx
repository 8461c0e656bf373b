import { useOutcome } from "../../calculation/outcome.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { timeContents } from "../../findings/effect/time-contents.ts";
import { useTextsOrNull } from "../../base/settings/use-texts.ts";

/** Shown instead of the rapid rate when the machine states its own. */
export function MachineRapid() {
  const t = useTextsOrNull("machine");
  const language = useSettings((s) => s.language);
  const run = useOutcome((s) => s.pictured?.run);
  if (!t || !run) return null;
  return (
    <p className="small soft">
      {timeContents(t.time, run, language).slice(0, 2).join(". ")}. {t.time.hint}
    </p>
  );
}
