import { useMemo } from "react";
import type { Cycle, Given } from "../../cycles/define.ts";
import { HelpPicture } from "../help/HelpPicture.tsx";
import { exampleDraft, readDraft } from "../../program/read-draft.ts";
import { useSettings } from "../settings/settings.ts";

const nothing: Given = { contour: null };

/** What a cycle makes, drawn from the values of its printed example. */
export function CycleSketch({ cycle }: { readonly cycle: Cycle }) {
  const language = useSettings((s) => s.language);
  const values = useMemo(() => readDraft(cycle, exampleDraft(cycle)).values, [cycle]);
  return (
    <div className="cycle-sketch">
      <HelpPicture cycle={cycle} values={values} given={nothing} activeQ={null} language={language} />
    </div>
  );
}
