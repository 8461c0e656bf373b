import { useEffect, useMemo, useState } from "react";
import type { Job } from "../../program/job/job.ts";
import type { NcOutput } from "../../program/machine/nc-output.ts";
import { isoFile, manualText, printedText, type IsoFile } from "./printed.ts";
import { useSettings } from "../base/settings/settings.ts";
import { bundleOf, change, openContent, useEditor } from "./store.ts";
import { takeAnswer } from "../base/until-gone.ts";

/** Kind of the exported file. */
export type FileKind = "tnc640" | "tnc7" | "iso";

/** The file kind of a job; the manual layout is for reading only and exports as TNC 640. */
const kindOf = (layout: Job["layout"]): FileKind => (layout === "manual" ? "tnc640" : layout);

/** The file kind of the open work: a job's own setting, for a program that of its control. */
export function useFileKind(): FileKind {
  const layout = useEditor((s) => s.job?.layout ?? null);
  const own = useEditor((s) => bundleOf(s).control);
  const device = useSettings((s) => s.control);
  if (layout !== null) return kindOf(layout);
  return (own ?? device) === "TNC7" ? "tnc7" : "tnc640";
}

/** The DIN/ISO file of a job that is exported as one, once its printer is loaded; else null. */
export function useIsoFile(job: Job | null): IsoFile | null {
  const text = job?.layout === "iso" ? printedText(job) : null;
  const [iso, setIso] = useState<IsoFile | null>(null);
  useEffect(() => (text === null ? undefined : takeAnswer(() => isoFile(text), setIso)), [text]);
  return text === null ? null : iso;
}

/** The shown text of a job: its file, or the manual layout. */
export function useShownText(job: Job): { readonly text: string; readonly iso: IsoFile | null } {
  const iso = useIsoFile(job);
  const manual = useMemo(() => (job.layout === "manual" ? manualText(job) : null), [job]);
  return { text: manual ?? iso?.text ?? printedText(job), iso };
}

/** The NC output of the open work, by default that of this device. */
export function useOutput(): NcOutput {
  const own = useEditor((s) => openContent(s)?.output);
  const device = useSettings((s) => s.output);
  return own ?? device;
}

/** The same outside of a component. */
export const outputInUse = (): NcOutput => openContent()?.output ?? useSettings.getState().output;

/** Changes the NC output of the open work as one step of undo. */
export const setOutput = (output: NcOutput): void => change((work) => ({ ...work, output }), "output");
