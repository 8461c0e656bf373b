import { draftOf } from "../../document/edits.ts";
import { Icon } from "../../base/Icon.tsx";
import { openPrompt, usePlace } from "../../place/place.ts";
import type { JobReading } from "../../document/reading.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Back from the contour to the prompt that was left, or past the contour prompt to the first of the cycle. */
export function BackToPrompts({ read: { job, cycle } }: { readonly read: JobReading }) {
  const {
    dialog: { contour: t },
  } = useTexts();
  const left = usePlace((p) => p.prompt);
  const [first = null] = Object.keys(cycle.params);
  const to = left === "contour" && job.contour.length > 0 ? first : left;
  return (
    <button
      type="button"
      className="button back-to-prompts"
      onClick={() => openPrompt(to, to === null ? "" : (draftOf(job)[to] ?? ""))}
    >
      <Icon name="back" /> {t.back}
    </button>
  );
}
