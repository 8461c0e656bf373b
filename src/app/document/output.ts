import { useEffect, useMemo, useState } from "react";
import type { Job } from "../../program/job/job.ts";
import type { NcOutput } from "../../program/machine/nc-output.ts";
import { isoFile, manualText, printedText, type IsoFile } from "./printed.ts";
import { useSettings } from "../base/settings/settings.ts";
import { changeProgram, edit, handedOn, useEditor } from "./store.ts";

/** What kind of file leaves the page. */
export type FileKind = "tnc640" | "tnc7" | "iso";

/** The file of a job; the look of the manual is none, the file is that of the TNC 640 then. */
const kindOf = (layout: Job["layout"]): FileKind => (layout === "manual" ? "tnc640" : layout);

/** What kind of file the open work leaves as: as a job is set, and a program by the control it runs on. */
export function useFileKind(): FileKind {
  const layout = useEditor((s) => s.job?.layout ?? null);
  const own = useEditor((s) => handedOn(s).control);
  const device = useSettings((s) => s.control);
  if (layout !== null) return kindOf(layout);
  return (own ?? device) === "TNC7" ? "tnc7" : "tnc640";
}

/** The DIN/ISO file of a job that leaves as one, once its printer is here; null otherwise. */
export function useIsoFile(job: Job | null): IsoFile | null {
  const text = job?.layout === "iso" ? printedText(job) : null;
  const [iso, setIso] = useState<IsoFile | null>(null);
  useEffect(() => {
    let gone = false;
    if (text !== null) void isoFile(text).then((made) => !gone && setIso(made));
    return () => {
      gone = true;
    };
  }, [text]);
  return text === null ? null : iso;
}

/** What is shown of a job: its file, or the look of the manual. */
export function useShownText(job: Job): { readonly text: string; readonly iso: IsoFile | null } {
  const iso = useIsoFile(job);
  const manual = useMemo(() => (job.layout === "manual" ? manualText(job) : null), [job]);
  return { text: manual ?? iso?.text ?? printedText(job), iso };
}

/** How the open work is written; as this device writes where it says nothing. */
export function useOutput(): NcOutput {
  const own = useEditor(({ job, program }) => (job ?? program)?.output);
  const device = useSettings((s) => s.output);
  return own ?? device;
}

/** The same, outside of a component. */
export function outputInUse(): NcOutput {
  const { job, program } = useEditor.getState();
  return (job ?? program)?.output ?? useSettings.getState().output;
}

/** Changes how the open work is written, as one step of undo. */
export function setOutput(output: NcOutput): void {
  const put = <W extends { readonly output?: NcOutput }>(work: W): W => ({ ...work, output });
  if (useEditor.getState().program) changeProgram(put, "output");
  else edit(put, "output");
}
