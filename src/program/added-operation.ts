import { cycleByNumber } from "../cycles/index.ts";
import { withInserted } from "../nc/edit.ts";
import type { Program } from "../nc/program.ts";
import type { Statement } from "../nc/statement.ts";
import { wordsOf } from "./flow.ts";
import type { SetJob } from "./job.ts";
import { jobStatements, type Labels } from "./print-job.ts";

/** Ends of a main program. */
const ENDS: ReadonlySet<number> = new Set([2, 30]);

const endsMain = (s: Statement) => s.kind === "end" || (wordsOf(s)?.functions.some((m) => ENDS.has(m)) ?? false);

/** The lowest label number that a program has not. */
function freeLabel({ blocks }: Program): number {
  const used = new Set(blocks.flatMap(({ statement: s }) => (s.kind === "label" ? [s.label] : [])));
  let n = 1;
  while (used.has(n)) n += 1;
  return n;
}

/**
 * A program with the operation of a work behind all others: its tool call, its cycle and its call in front of the end of the main
 * program, and its contour, under a label of its own, at the end of the file.
 */
export function withOperation(program: Program, job: SetJob, labels: Labels): Program {
  const cycle = cycleByNumber(job.cycle);
  if (!cycle) return program;
  const label = freeLabel(program);
  const all = jobStatements(job, cycle, labels).map((s): Statement => {
    if (s.kind === "cycleLine" && s.line === 1) return { ...s, text: `${labels.contour.label}${label}` };
    return s.kind === "label" && s.label !== 0 ? { ...s, label } : s;
  });
  const ending = all.findIndex(endsMain);
  const main = all.slice(all.findIndex((s) => s.kind === "toolCall"), ending);
  const subprogram = all.slice(ending + 1).filter((s) => s.kind !== "end");
  const put = (into: Program, index: number, statements: readonly Statement[]) =>
    statements.reduce((now, s, i) => withInserted(now, index + i, s), into);
  const placeOf = (into: Program, is: (s: Statement) => boolean) => {
    const found = into.blocks.findIndex(({ statement }) => is(statement));
    return found < 0 ? into.blocks.length : found;
  };
  const operated = put(program, placeOf(program, endsMain), main);
  return put(operated, placeOf(operated, (s) => s.kind === "end"), subprogram);
}
