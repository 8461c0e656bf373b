import { cycleByNumber } from "../../cycles/index.ts";
import type { ShapeRequest } from "../../cycles/shape-request.ts";
import { programText } from "../../nc/print.ts";
import type { Statement } from "../../nc/statement.ts";
import type { SetJob } from "./job.ts";
import { contourStatements } from "./print-contour.ts";
import { jobStatements, styleOfJob, type Labels } from "./print-job.ts";
import { ringOf } from "./requested-job.ts";
import { blankRings, rowsOf } from "./requested-shape.ts";
import { part, type Ring, type Segment } from "../../kernel/geometry/point.ts";

/** Label of the blank outline; the contour has another one. */
const BLANK_LABEL = 1;

/** Closed outline of a ring. */
const round = (ring: Ring): Segment[] =>
  ring.flatMap((to, i) => {
    const from = ring.at(i - 1);
    return from ? [part.line(from, to)] : [];
  });

/** Program text of a job; a blank with the shape of the part is written as an outline. */
export function requestedText(job: SetJob, wanted: ShapeRequest, labels: Labels): string {
  const cycle = cycleByNumber(job.cycle);
  if (!cycle) return "";
  const plain = jobStatements(job, cycle, labels);
  const [shaped] = wanted.allowance > 0 ? blankRings(wanted, [ringOf(job.blank)]) : [];
  if (!shaped) return programText(plain, styleOfJob(job), job.output.numbered);
  const blank: Statement = {
    kind: "blankRotation",
    axis: "Z",
    measure: "D",
    outline: { label: BLANK_LABEL },
    inner: null,
  };
  const outline: Statement[] = [
    { kind: "label", label: BLANK_LABEL },
    ...contourStatements(rowsOf(round(shaped))),
    {
      kind: "label",
      label: 0,
    },
  ];
  const all = plain.map((s) => (s.kind === "blankCylinder" ? blank : s));
  return programText([...all.slice(0, -1), ...outline, ...all.slice(-1)], styleOfJob(job), job.output.numbered);
}
