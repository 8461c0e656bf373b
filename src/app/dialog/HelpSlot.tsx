import { useMemo } from "react";
import { exampleJob } from "../../program/job.ts";
import { givenOf } from "../engine/given.ts";
import { HelpPicture } from "../help/HelpPicture.tsx";
import type { Numbers } from "../../view/help/lettering.ts";
import type { JobReading } from "../reading.ts";
import { useSettings } from "../settings/settings.ts";

/** The help picture beside the prompts: this contour, the open prompt's dimension strong. */
export function HelpSlot({ read, q }: { readonly read: JobReading; readonly q: string | null }) {
  const language = useSettings((s) => s.language);
  const unwritten = read.job.contour.length === 0 && !read.reading.values;
  const given = useMemo(() => givenOf(unwritten ? { cycle: read.cycle, job: exampleJob(read.cycle) } : read), [unwritten, read]);
  // What acts where it is defined has no contour to draw.
  if (read.cycle.acts) return null;
  return (
    <div className="help-slot">
      <HelpPicture cycle={read.cycle} values={read.reading.values} partial={read.reading.partial as Numbers} given={given} activeQ={q}
        language={language} />
    </div>
  );
}
