import type { Job } from "../../../program/job/job.ts";
import { exportedText } from "../../document/printed.ts";
import { copyText } from "../../findings/copy.ts";
import { confirmExport } from "./confirm-export.ts";

/** Copies a text of the open work; one with faults only after confirmation. */
export async function copyProgram(text: string): Promise<void> {
  const verdict = await confirmExport("copy");
  if (verdict) await copyText(text, verdict);
}

/** Copies the program of a job as the file that its control loads. */
export const copyJob = async (job: Job): Promise<void> => copyProgram(await exportedText(job));
