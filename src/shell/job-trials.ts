import type { FindingsTexts } from "../i18n/en/workplace/findings.ts";
import { valueInProgram } from "../program/blocks/cycle-values.ts";
import { promptOf, threadCures, type Overrun } from "../app/fields/blocks/thread-cures.ts";
import { draftOf, setPrompts } from "../app/document/edits.ts";
import { printedText, programName } from "../app/document/printed.ts";
import type { JobReading } from "../app/document/reading.ts";
import { closeStep } from "../app/document/steps.ts";
import { onlyBundle } from "../app/document/work.ts";
import type { Trial } from "../app/findings/host.ts";

/** Changes of a job that may keep the overrun of its thread out of the part. Its blank has no shoulder for an undercut. */
export function jobTrials({ job, cycle, reading }: JobReading, issue: Overrun, t: FindingsTexts): readonly Trial[] {
  const hasRunOut = !!reading.partial[promptOf(cycle, "threadRunOut") ?? ""];
  const typed = (q: string, mm: number) => String(valueInProgram(cycle.params[q], mm, false));
  return threadCures(cycle, issue, hasRunOut, typed).map(({ kind, text, prompts }) => ({
    group: kind,
    name: kind === "runOut" ? t.runOut(text) : t.endThread(text),
    work: () => {
      const changed = printedText({ ...job, drafts: { ...job.drafts, [job.cycle]: { ...draftOf(job), ...prompts } } });
      return { ...onlyBundle(job), name: `${programName(changed)}.h`, text: changed, encoding: "utf-8" };
    },
    apply: () => {
      closeStep();
      setPrompts(prompts);
      closeStep();
    },
  }));
}
