import type { Cycle } from "../../cycles/define.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import type { Job, SetJob } from "../../program/job/job.ts";
import { knownParameters } from "../../program/job/job-parameters.ts";
import { readDraft, type Draft, type DraftInches, type DraftReading } from "../../program/job/read-draft.ts";
import { setupOf, withSetup, type Setup } from "../../program/job/setup.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { draftOf } from "./edits.ts";
import { useEditor, type Editor } from "./store.ts";
import { toolTable, useToolList } from "./work-tools.ts";

/** The open job with its cycle and the values of its prompts. */
export interface JobReading {
  /** The job with proposed values where its set-up is empty. */
  readonly job: SetJob;
  /** Null for a block of a program, which has no set-up of its own. */
  readonly setup: Setup | null;
  /** The tools that can be called. */
  readonly tools: readonly Tool[];
  readonly cycle: Cycle;
  readonly draft: Draft;
  /** The values of the draft, in mm. */
  readonly reading: DraftReading;
  /** How the numbers of the draft count in inches; absent: in mm. */
  readonly inches?: DraftInches;
}

interface Completed {
  readonly tools: readonly Tool[];
  readonly setup: Setup;
  readonly job: SetJob;
}

const completed = new WeakMap<Job, Completed>();

/** A job with its complete set-up, cached per state of the job and the tool table. */
function completedBy(job: Job, tools: readonly Tool[]): Completed {
  const known = completed.get(job);
  if (known?.tools === tools) return known;
  const setup = setupOf(job, tools);
  const made = { tools, setup, job: withSetup(job, setup) };
  completed.set(job, made);
  completed.set(made.job, made);
  return made;
}

/** The job with a complete set-up, for printing, drawing and running. */
export const completeJob = (job: Job, tools: readonly Tool[] = toolTable().tools): SetJob =>
  completedBy(job, tools).job;

const read = new WeakMap<SetJob, JobReading>();

/** Reads the prompts of a job, cached per state; null if its cycle is not in the catalogue. */
export function readJob(typed: Job, tools: readonly Tool[] = toolTable().tools): JobReading | null {
  const { job, setup } = completedBy(typed, tools);
  const known = read.get(job);
  if (known) return known;
  const cycle = cycleByNumber(job.cycle);
  if (!cycle) return null;
  const draft = draftOf(job);
  const made = { job, setup, tools, cycle, draft, reading: readDraft(cycle, draft, knownParameters(job)) };
  read.set(job, made);
  return made;
}

/** The open job, read; null on the start page. */
export const useReading = (): JobReading | null => {
  const job = useEditor((s) => s.job);
  const tools = useToolList();
  return job && readJob(job, tools);
};

/** The same outside of a component; null also for a program. */
export const openReading = ({ job }: Editor = useEditor.getState()): JobReading | null => job && readJob(job);
