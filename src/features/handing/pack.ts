import { rowsCalled } from "../../program/tools/tool-list.ts";
import { time } from "../../app/base/clock.ts";
import { draftOf } from "../../app/document/edits.ts";
import { reportOf } from "../../app/calculation/beside.ts";
import { fileOfJob } from "../../app/document/printed.ts";
import { setJobOf } from "../../app/document/reading.ts";
import { writeArchive } from "../../app/records/archive.ts";
import { controlInUse, listInUse, machineInUse } from "../../app/document/work-tools.ts";
import { isProgram, type Work } from "../../app/document/work.ts";
import type { Job } from "../../program/job/job.ts";

/** The open work, ready to leave. */
export interface Packed {
  /** With all that it runs with here. */
  readonly work: Work;
  /** Name of its program file. */
  readonly file: string;
  /** What it comes to, for comparison; null when the calculation did not say. */
  readonly report: string | null;
}

/** The cycle alone, with the tool that is proposed where none was chosen: another table might propose another one. */
const alone = (job: Job): Job => ({ ...job, tool: setJobOf(job).tool, drafts: { [job.cycle]: draftOf(job) } });

/** Packs the open work with the tools that it uses, the control it runs as and the machine of its times. */
export async function packed(open: Work): Promise<Packed> {
  const file = isProgram(open) ? open.name : fileOfJob(open);
  const [list, control, machine] = [listInUse(), controlInUse(), machineInUse()];
  const made = await reportOf(open, file);
  const tools = rowsCalled(list, made?.used ?? null);
  return {
    work: { ...(isProgram(open) ? open : alone(open)), tools, control, machine },
    file,
    report: made?.text ?? null,
  };
}

/** The same as a file, with the tools once more as `verify` reads them. */
export const packedFile = ({ work }: Packed): Uint8Array<ArrayBuffer> =>
  writeArchive({ works: [{ work: "", savedAt: time(), job: work }], tools: work.tools ?? null });
