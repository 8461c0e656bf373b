import { boxAround } from "../../kernel/area/box.ts";
import type { Segment } from "../../kernel/geometry/point.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import { parse } from "../../nc/parse.ts";
import { clampingIn } from "../../program/clamping/draft.ts";
import type { BlankDraft } from "../../program/job/job.ts";
import { rowsOf } from "../../program/job/requested-shape.ts";
import type { Run } from "../../program/state/run-types.ts";
import { newPart, type FinishedPart } from "../../planning/part/finished-part.ts";
import { siteOfOperation } from "../../app/document/region.ts";
import { useEditor } from "../../app/document/store.ts";
import { useOutcome } from "../../app/calculation/outcome.ts";
import { adopted } from "./part-rows.ts";

/** The contour of the operations on a side that reaches furthest along Z. */
function longestContour({ operations }: Run, side: "outside" | "inside"): readonly Segment[] {
  const length = (contour: readonly Segment[]) => {
    const all = contour.flatMap(({ from, to }) => [from.z, to.z]);
    return all.length === 0 ? 0 : Math.max(...all) - Math.min(...all);
  };
  return operations
    .filter((operation) => siteOfOperation(operation) === side)
    .map(({ plan }) => plan.contour ?? [])
    .reduce((best, next) => (length(next) > length(best) ? next : best), []);
}

const text = (n: number) => String(Number(n.toFixed(3)) || 0);

/** Blank of a run as a cylinder around it. */
function blankDraft({ blank }: Run): BlankDraft | null {
  if (!blank || blank.length === 0) return null;
  const { left, right, low, high } = boxAround(blank);
  return {
    outside: text(toDiameter(radius(high))),
    bore: text(toDiameter(radius(low))),
    length: text(right - left),
    allowance: text(right),
  };
}

/**
 * The part that the open program turns: its contours as far as its operations describe them, its blank, clamping and
 * material. Null where nothing describes a contour.
 */
export function partOfProgram(): FinishedPart | null {
  const { job, program } = useEditor.getState();
  const run = useOutcome.getState().newest?.run;
  const work = job ?? program;
  if (!work || !run) return null;
  const own = job && job.contour.length > 0 ? job.contour : null;
  const [operation] = run.operations;
  const isBore = own !== null && operation !== undefined && siteOfOperation(operation) === "inside";
  const outside = own && !isBore ? own : rowsOf(longestContour(run, "outside")),
    inside = isBore ? own : rowsOf(longestContour(run, "inside"));
  if (outside.length + inside.length === 0) return null;
  const name = job ? job.name : run.program.name;
  return adopted({
    ...newPart(name),
    outside,
    inside: inside.map((row) => ({ ...row, id: `bore ${row.id}` })),
    ...(work.material !== undefined && { material: work.material }),
    blank: job && job.blank.outside !== "" ? job.blank : blankDraft(run),
    clamping: job ? (job.clamping ?? null) : (clampingIn(parse(program?.text ?? ""))?.draft ?? null),
  });
}
