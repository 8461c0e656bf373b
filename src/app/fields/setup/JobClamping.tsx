import { proposedClamping } from "../../../program/clamping/draft.ts";
import { boundsOf } from "../../../view/bounds.ts";
import { setClamping } from "../../document/edits.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import type { JobReading } from "../../document/reading.ts";
import { ClampingFields } from "./ClampingFields.tsx";
import { useTextsOrNull } from "../../base/settings/use-texts.ts";

/** Assumed size of an unknown blank, mm. */
const SOME_BLANK = { left: -80, right: 0, high: 30 };

/** Clamping of a job. */
export function JobClamping({ read: { job } }: { readonly read: JobReading }) {
  const t = useTextsOrNull("clamping");
  const blank = useOutcome((s) => s.shown?.run.blank);
  return (
    t && (
      <fieldset className="setup-group">
        <legend>{t.title}</legend>
        <ClampingFields
          draft={job.clamping ?? null}
          set={setClamping}
          propose={() => proposedClamping(boundsOf(blank?.flat() ?? []) ?? SOME_BLANK)}
        />
      </fieldset>
    )
  );
}
