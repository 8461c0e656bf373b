import { cycleByNumber } from "../../cycles/index.ts";
import type { Program } from "../../nc/program.ts";
import { withBlocks } from "../../nc/replace.ts";
import type { Statement } from "../../nc/statement.ts";
import { noWords, type Label } from "../../nc/words.ts";
import type { SetJob } from "../job/job.ts";
import { blocksOfStatements, withAddedBehind } from "./operation-edits.ts";
import { endsMain, operationsOf } from "./operations.ts";
import { outputIn } from "./output-in.ts";
import { jobStatements, type Labels } from "../job/print-job.ts";

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

/**
 * Adds the operation of a job to a program: structure item, tool call, spindle, feed unit, approach, cycle, call,
 * retraction, and its contour under its own label at the end of the file. Adds turning mode and M30 where missing.
 */
export function withOperation(
  program: Program,
  job: SetJob,
  labels: Labels,
  { behind, title, contour }: OperationPlace = {},
): Program {
  const cycle = cycleByNumber(job.cycle);
  if (!cycle) return program;
  const label = contour ?? freeLabel(program);
  const named = typeof label === "number" ? String(label) : `"${label}"`;
  const output = outputIn(program, job.output);
  const all = jobStatements({ ...job, output }, cycle, labels).map((s): Statement => {
    if (s.kind === "cycleLine" && s.line === 1) return { ...s, text: `${labels.contour.label}${named}` };
    return s.kind === "label" && s.label !== 0 ? { ...s, label } : s;
  });
  const ending = all.findIndex(endsMain);
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
  const main: readonly Statement[] = [
    ...(isTurning ? [] : [TURNING]),
    ...(title === undefined || title.trim() === "" ? [] : [{ kind: "structure" as const, text: title.trim() }]),
    ...all
      .slice(
        all.findIndex((s) => s.kind === "toolCall"),
        ending,
      )
      .filter((s) => !stops(s)),
  ];
  const operated = withAddedBehind(ended, place < 0 ? null : place, blocksOfStatements(ended, from, main));
  const subprogram = contour === undefined ? all.slice(ending + 1).filter((s) => s.kind !== "end") : [];
  const end = operated.blocks.findLastIndex(({ statement: s }) => s.kind === "end");
  const at = end < 0 ? operated.blocks.length : end;
  const behindIt = [
    ...operated.blocks.slice(0, at),
    ...blocksOfStatements(operated, at, subprogram),
    ...operated.blocks.slice(at),
  ];
  return subprogram.length > 0 ? withBlocks(operated, behindIt) : operated;
}
