import { ncLabels } from "../i18n/nc-labels.ts";
import type { Tool } from "../kernel/tool.ts";
import type { Job, SetJob } from "../program/job.ts";
import { printJob } from "../program/print-job.ts";
import { setJobOf } from "./reading.ts";

const printed = new WeakMap<SetJob, string>();

/**
 * The program text of a job with its set-up, in its own layout and label language, made once per state of the job. Its tools are those of
 * the open work where no others are given.
 */
export function printedText(typed: Job, tools?: readonly Tool[]): string {
  const job = setJobOf(typed, tools);
  const known = printed.get(job);
  if (known !== undefined) return known;
  const text = printJob(job, ncLabels(job.ncLanguage));
  printed.set(job, text);
  return text;
}

/** The name in BEGIN PGM, which is also the name of the file. */
export const programName = (text: string): string => /BEGIN PGM (\S+)/.exec(text)?.[1] ?? "PROGRAM";

/** Blocks of a program: lines that begin with a block number. */
export const blockCount = (text: string): number => text.split("\n").filter((line) => /^\d+\s/.test(line)).length;
