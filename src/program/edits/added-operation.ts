import { cycleByNumber } from "../../cycles/index.ts";
import type { Program } from "../../nc/program.ts";
import { withBlocks } from "../../nc/replace.ts";
import type { Statement } from "../../nc/statement.ts";
import { noWords, type Label } from "../../nc/words.ts";
import type { SetJob } from "../job/job.ts";
import type { NcOutput } from "../machine/nc-output.ts";
import { blocksOfStatements, withAddedBehind } from "./operation-edits.ts";
import { endsMain, operationsOf } from "./operations.ts";
import { outputIn } from "./output-in.ts";
import { countsInches, statementsInUnit } from "./program-unit.ts";
import { jobStatements, machiningStatements, startStatement, type Labels } from "../job/print-job.ts";

/** Place and title of an added operation. */
export interface OperationPlace {
  /** Behind this operation; null: before the first; absent: behind the last. */
  readonly behind?: number | null;
  /** Words of its structure comment. */
  readonly title?: string;
  /** A contour of the program that the cycle takes; absent: its own contour is added. */
  readonly contour?: Label;
}

/** Lowest free label number of a program. */
function freeLabel({ blocks }: Program): number {
  const used = new Set(blocks.flatMap(({ statement: s }) => (s.kind === "label" ? [s.label] : [])));
  let n = 1;
  while (used.has(n)) n += 1;
  return n;
}

const functionsOf = (m: number): Statement => ({ kind: "functions", words: { ...noWords, functions: [m] } });
const TURNING: Statement = { kind: "mode", mode: "TURN", kinematics: null };

/** The program with M30 or M2 added before its subprograms, where it lacks both. */
function withEnd(program: Program, end: 30 | 2): Program {
  const { blocks } = program;
  const { to } = operationsOf(program);
  const s = blocks[to]?.statement;
  if (s && endsMain(s) && s.kind !== "end") return program;
  return withBlocks(program, [
    ...blocks.slice(0, to),
    ...blocksOfStatements(program, to, [functionsOf(end)]),
    ...blocks.slice(to),
  ]);
}

/** What is added: the blocks from the tool call to the retraction, and a contour under its label. */
interface AddedStatements {
  readonly main: readonly Statement[];
  readonly contour: readonly Statement[];
  readonly output: NcOutput;
}

/** Adds blocks as an operation, with turning mode and M30 where they are missing. */
function withStatements(
  program: Program,
  { main, contour, output }: AddedStatements,
  { behind, title }: OperationPlace,
): Program {
  const ended = withEnd(program, output.end);
  const { from, units } = operationsOf(ended);
  const place = behind === undefined ? units.length - 1 : (behind ?? -1);
  const before = ended.blocks
    .slice(0, place < 0 ? from : (units[place]?.to ?? from))
    .findLast(({ statement: s }) => s.kind === "mode");
  const isTurning = before?.statement.kind === "mode" && before.statement.mode === "TURN";
  // A stopped spindle between operations would leave the next one without a spindle.
  const isLast = place === units.length - 1;
  const stops = (s: Statement) =>
    !isLast && JSON.stringify(s) === JSON.stringify(functionsOf(output.spindleOff ?? NaN));
  const added: readonly Statement[] = [
    ...(isTurning ? [] : [TURNING]),
    ...(title === undefined || title.trim() === "" ? [] : [{ kind: "structure" as const, text: title.trim() }]),
    ...main.filter((s) => !stops(s)),
  ];
  const operated = withAddedBehind(ended, place < 0 ? null : place, blocksOfStatements(ended, from, added));
  if (contour.length === 0) return operated;
  const end = operated.blocks.findLastIndex(({ statement: s }) => s.kind === "end");
  const at = end < 0 ? operated.blocks.length : end;
  return withBlocks(operated, [
    ...operated.blocks.slice(0, at),
    ...blocksOfStatements(operated, at, contour),
    ...operated.blocks.slice(at),
  ]);
}

/**
 * Adds the operation of a job, in mm, to a program: structure item, tool call, spindle, feed unit, approach, cycle, call,
 * retraction, and its contour under its own label at the end of the file.
 */
export function withOperation(program: Program, job: SetJob, labels: Labels, place: OperationPlace = {}): Program {
  const cycle = cycleByNumber(job.cycle);
  if (!cycle) return program;
  const label = place.contour ?? freeLabel(program);
  const named = typeof label === "number" ? String(label) : `"${label}"`;
  const output = outputIn(program, job.output);
  const all = jobStatements({ ...job, output }, cycle, labels).map((s): Statement => {
    if (s.kind === "cycleLine" && s.line === 1) return { ...s, text: `${labels.contour.label}${named}` };
    return s.kind === "label" && s.label !== 0 ? { ...s, label } : s;
  });
  const ending = all.findIndex(endsMain);
  const first = all.findIndex((s) => s.kind === "toolCall");
  // The rows of a contour are typed in the unit of the program.
  const contour = place.contour === undefined ? all.slice(ending + 1).filter((s) => s.kind !== "end") : [];
  const main = statementsInUnit(all.slice(first, ending), countsInches(program), job.perRevolution);
  return withStatements(program, { main, contour, output }, place);
}

/** Adds an operation without a turning cycle, in mm; `cut` begins and ends at the start point of the job. */
export function withHandOperation(
  program: Program,
  job: SetJob,
  cut: readonly Statement[],
  place: OperationPlace = {},
): Program {
  const output = outputIn(program, job.output);
  const planned = machiningStatements({ ...job, output }, [startStatement({ ...job, output }), ...cut]);
  const main = statementsInUnit(planned, countsInches(program), job.perRevolution);
  return withStatements(program, { main, contour: [], output }, place);
}
