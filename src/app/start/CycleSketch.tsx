import { useMemo } from "react";
import type { Cycle, Given } from "../../cycles/define.ts";
import { HelpPicture } from "../help/HelpPicture.tsx";
import { readRows } from "../../program/contour-rows.ts";
import { exampleJob } from "../../program/job.ts";
import { exampleDraft, readDraft } from "../../program/read-draft.ts";
import { useSettings } from "../settings/settings.ts";

/** What a cycle makes, drawn from the values of its printed example. */
export function CycleSketch({ cycle }: { readonly cycle: Cycle }) {
  const language = useSettings((s) => s.language);
  const values = useMemo(() => readDraft(cycle, exampleDraft(cycle)).values, [cycle]);
  const given = useMemo(
    (): Given => ({ contour: cycle.contour === "free" ? readRows(exampleJob(cycle).contour).contour.segments : null, start: null }),
    [cycle],
  );
  return (
    <div className="cycle-sketch">
      <HelpPicture cycle={cycle} values={values} given={given} activeQ={null} language={language} />
    </div>
  );
}
