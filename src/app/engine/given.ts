import type { Given } from "../../cycles/define.ts";
import { at } from "../../kernel/curve.ts";
import type { Pt } from "../../kernel/point.ts";
import { diameter, toRadius } from "../../kernel/units.ts";
import { readRows } from "../../program/contour-rows.ts";
import { readExpression } from "../../program/expression.ts";
import type { Job } from "../../program/job.ts";
import { knownParameters } from "../../program/job-parameters.ts";
import type { JobReading } from "../reading.ts";

const read = new WeakMap<Job["contour"], Given["contour"]>();

/** The contour of the table, read once per state of the table. */
function contourOf(rows: Job["contour"]): Given["contour"] {
  const known = read.get(rows);
  if (known !== undefined) return known;
  const { segments } = readRows(rows).contour;
  const contour = segments.length > 0 ? segments : null;
  read.set(rows, contour);
  return contour;
}

/** The start point as typed; null as long as it is no place. */
function startOf(job: Job): Pt | null {
  const [x, z] = [job.start.x, job.start.z].map((typed) => readExpression(typed, knownParameters(job)));
  return x?.kind === "number" && z?.kind === "number" ? at(z.value, toRadius(diameter(x.value))) : null;
}

/** What the cycle of a job is given beside its values: the contour of the table, and the start point. */
export const givenOf = ({ cycle, job }: Pick<JobReading, "cycle" | "job">): Given =>
  ({ contour: cycle.contour === "free" ? contourOf(job.contour) : null, start: startOf(job) });
