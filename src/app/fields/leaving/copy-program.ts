import type { Job } from "../../../program/job/job.ts";
import { leavingText, printedText } from "../../document/printed.ts";
import { copyText } from "../../findings/copy.ts";
import { mayLeave } from "./leaving.ts";

/** Copies a program or its selected part; one with faults only after confirmation. */
export async function copyProgram(program: string, marked = program): Promise<void> {
  const verdict = await mayLeave("copy", program);
  if (verdict) await copyText(marked, verdict);
}

/** Copies the program of a job as the file that its control loads. */
export const copyJob = async (job: Job): Promise<void> => copyProgram(printedText(job), await leavingText(job));
