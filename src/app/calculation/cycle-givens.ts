import type { Given } from "../../cycles/define.ts";
import { at, type Pt } from "../../kernel/geometry/point.ts";
import { diameter, toRadius } from "../../kernel/units.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import { contourInMillimetres } from "../../program/edits/program-unit.ts";
import { readText } from "../../program/values/field.ts";
import type { Job } from "../../program/job/job.ts";
import { knownParameters } from "../../program/job/job-parameters.ts";
import { SETUP_FIELDS } from "../../program/job/setup-fields.ts";
import type { JobReading } from "../document/reading.ts";

/** The contour from the table. */
function contourOf(rows: Job["contour"], inches: boolean): Given["contour"] {
  const segments = contourInMillimetres(readRows(rows).contour.segments, inches);
  return segments.length > 0 ? segments : null;
}

/** The typed start point; null if it cannot be read. */
function startOf(job: Job): Pt | null {
  const known = knownParameters(job);
  const x = readText(SETUP_FIELDS.startX, job.start.x, known).value;
  const z = readText(SETUP_FIELDS.startZ, job.start.z, known).value;
  return x === null || z === null ? null : at(z, toRadius(diameter(x)));
}

/** The inputs of a job's cycle other than its values: the contour from the table, and the start point. */
export const cycleGivens = ({ cycle, job, inches }: Pick<JobReading, "cycle" | "job" | "inches">): Given => ({
  contour: cycle.contour === "free" ? contourOf(job.contour, inches !== undefined) : null,
  start: startOf(job),
});
