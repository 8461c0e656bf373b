import { rowsCalled } from "../../program/tools/tool-list.ts";
import { time } from "../../app/base/clock.ts";
import { draftOf } from "../../app/document/edits.ts";
import { reportOf } from "../../app/calculation/other-outcome.ts";
import { fileOfWork } from "../../app/document/printed.ts";
import { completeJob } from "../../app/document/reading.ts";
import { writeArchive } from "../../app/records/archive.ts";
import { controlInUse, listInUse, machineInUse } from "../../app/document/work-tools.ts";
import { isProgram, type Work } from "../../app/document/work.ts";
import type { Job } from "../../program/job/job.ts";

/** The open work, packed for sharing. */
export interface Packed {
  /** With the tools, control and machine it uses here. */
  readonly work: Work;
  /** Name of its program file. */
  readonly file: string;
  /** The report for comparison; null if the calculation failed. */
  readonly report: string | null;
}

/** The cycle alone, with the proposed tool if none was chosen: another table might propose another one. */
const selfContainedJob = (job: Job): Job => ({
  ...job,
  tool: completeJob(job).tool,
  drafts: { [job.cycle]: draftOf(job) },
});

/** Packs the open work with the tools it uses, its control and its machine. */
export async function packWork(open: Work): Promise<Packed> {
  const file = fileOfWork(open);
  const [list, control, machine] = [listInUse(), controlInUse(), machineInUse()];
  const made = await reportOf(open, file);
  const tools = rowsCalled(list, made?.used ?? null);
  return {
    work: { ...(isProgram(open) ? open : selfContainedJob(open)), tools, control, machine },
    file,
    report: made?.text ?? null,
  };
}

/** The packed work as a file, with an extra copy of the tools for `verify`. */
export const packedFile = ({ work }: Packed): Uint8Array<ArrayBuffer> =>
  writeArchive({ works: [{ work: "", savedAt: time(), job: work }], tools: work.tools ?? null });
