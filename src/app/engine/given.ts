import type { Given } from "../../cycles/define.ts";
import { readRows } from "../../program/contour-rows.ts";
import type { Job } from "../../program/job.ts";
import type { JobReading } from "../reading.ts";

const nothing: Given = { contour: null };
const read = new WeakMap<Job["contour"], Given>();

/** The contour that a free-contour cycle is given by the table, read once per state of the table. */
export function givenOf({ cycle, job }: Pick<JobReading, "cycle" | "job">): Given {
  if (cycle.contour !== "free") return nothing;
  const known = read.get(job.contour);
  if (known) return known;
  const { segments } = readRows(job.contour).contour;
  const given = { contour: segments.length > 0 ? segments : null };
  read.set(job.contour, given);
  return given;
}
