import type { Job } from "../../../program/job/job.ts";
import { exportedText, printedText } from "../../document/printed.ts";
import { copyText } from "../../findings/copy.ts";
import { confirmExport } from "./confirm-export.ts";

/** Copies a program or its selected part; one with faults only after confirmation. */
export async function copyProgram(program: string, marked = program): Promise<void> {
  const verdict = await confirmExport("copy", program);
  if (verdict) await copyText(marked, verdict);
}

/** Copies the program of a job as the file that its control loads. */
export const copyJob = async (job: Job): Promise<void> => copyProgram(printedText(job), await exportedText(job));
