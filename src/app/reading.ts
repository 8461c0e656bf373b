import type { Cycle } from "../cycles/define.ts";
import { cycleByNumber } from "../cycles/index.ts";
import type { Job } from "../program/job.ts";
import { knownParameters } from "../program/job-parameters.ts";
import { readDraft, type Draft, type DraftReading } from "../program/read-draft.ts";
import { draftOf } from "./edits.ts";
import { useEditor } from "./store.ts";

/** The open job with its cycle and what its prompts hold. */
export interface JobReading {
  readonly job: Job;
  readonly cycle: Cycle;
  readonly draft: Draft;
  readonly reading: DraftReading;
}

const read = new WeakMap<Job, JobReading>();

/** Reads the prompts of a job, once per state of the job; null when its cycle is not in the catalogue. */
export function readJob(job: Job): JobReading | null {
  const known = read.get(job);
  if (known) return known;
  const cycle = cycleByNumber(job.cycle);
  if (!cycle) return null;
  const draft = draftOf(job);
  const made = { job, cycle, draft, reading: readDraft(cycle, draft, knownParameters(job)) };
  read.set(job, made);
  return made;
}

/** The open job, read; null on the start page. */
export const useReading = (): JobReading | null => {
  const job = useEditor((s) => s.job);
  return job && readJob(job);
};
