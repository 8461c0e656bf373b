import { cycleByNumber } from "../../cycles/index.ts";
import type { Given } from "../../cycles/define.ts";
import { shippedTools } from "../../program/shipped-tools.ts";
import { parse } from "../../nc/parse.ts";
import { readContour } from "../../program/contour-subprogram.ts";
import { Machine } from "../../program/machine.ts";
import { readDraft } from "../../program/read-draft.ts";
import { run } from "../../program/run.ts";
import { rankTools, type ToolFit } from "../../program/which-tool.ts";
import { simulate } from "../../sim/simulate.ts";
import type { FeedUnit } from "../../kernel/move.ts";
import type { Pt } from "../../kernel/point.ts";
import type { Program } from "../../nc/program.ts";
import type { Job } from "../../program/job.ts";
import type { Outcome } from "./outcome.ts";

/** A program to calculate. */
export interface Request {
  readonly version: number;
  readonly text: string;
  /** Rapid rate for times, mm/min. */
  readonly rapid: number;
}

/** What tools are compared under: contour subprogram, start point, feed unit. */
export interface Circumstances {
  readonly given: Given;
  readonly start: Pt;
  readonly feedUnit: FeedUnit;
}

/** The contour behind the first label of a program; null when it has none. */
function givenBy(program: Program, rapid: number): Given {
  const machine = new Machine(program, { tools: shippedTools, rapid });
  const label = [...machine.labels.keys()][0];
  const read = label === undefined ? null : readContour(machine, label, 0);
  return { contour: read && read.contour.segments.length > 0 ? read.contour.segments : null };
}

/** Everything that takes time, as plain functions of plain data. Runs in a worker. */
export const engine = {
  /** From the program text to moves, stock, proof and times. */
  update({ version, text, rapid }: Request): Outcome {
    const program = parse(text);
    const made = run(program, { tools: shippedTools, rapid });
    const simulation = simulate({ blank: made.blank, steps: made.steps, operations: made.operations });
    return { version, text, run: made, simulation, given: givenBy(program, rapid) };
  },

  /** What each shipped tool can do with the values of a job, best first; null while they cannot be read. */
  fits(job: Job, { given, start, feedUnit }: Circumstances): readonly ToolFit[] | null {
    const cycle = cycleByNumber(job.cycle);
    const values = cycle && readDraft(cycle, job.drafts[job.cycle] ?? {}).values;
    return cycle && values ? rankTools(cycle, values, given, { start, feedUnit, autoFeed: null }, shippedTools) : null;
  },
};

export type Engine = typeof engine;
