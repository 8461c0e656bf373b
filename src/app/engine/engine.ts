import { cycleByNumber } from "../../cycles/index.ts";
import { parse } from "../../nc/parse.ts";
import { knownParameters } from "../../program/job-parameters.ts";
import { readDraft } from "../../program/read-draft.ts";
import type { ShopTools } from "../../program/read-tools.ts";
import { filesByName } from "../../program/program-files.ts";
import { run } from "../../program/run.ts";
import { rankTools, type ToolFit } from "../../program/which-tool.ts";
import { simulate } from "../../sim/simulate.ts";
import { tracing } from "../../sim/tracing.ts";
import type { FeedUnit } from "../../kernel/move.ts";
import type { Pt } from "../../kernel/point.ts";
import type { Tool } from "../../kernel/tool.ts";
import type { Control } from "../../program/plane-types.ts";
import type { SetJob } from "../../program/job.ts";
import type { Operation } from "../../program/run-types.ts";
import { givenOf } from "./given.ts";
import type { WorkFile } from "../work.ts";
import type { Outcome, Stage } from "./outcome.ts";

/** A program to calculate. */
export interface Request {
  readonly version: number;
  readonly text: string;
  /** Name of its file. */
  readonly name?: string;
  /** The files beside it: what it can call. */
  readonly files?: readonly Pick<WorkFile, "name" | "text">[];
  /** Blocks behind a skip mark are left out. */
  readonly skipMarked?: boolean;
  /** The tools that the program can call. */
  readonly table: ShopTools;
  /** Rapid rate for times, mm/min. */
  readonly rapid: number;
  /** How APPR and DEP move in the tool axis. */
  readonly control: Control;
}

/** What tools are compared under. */
export interface Circumstances {
  readonly start: Pt;
  readonly feedUnit: FeedUnit;
  readonly tools: readonly Tool[];
}

/** What trying other tools at a call of the run needs of it. */
export type Called = Pick<Operation, "cycle" | "tool" | "feedUnit" | "call">;

/** What every work needs that takes time, as plain functions of plain data. Runs in a worker. */
export const engine = {
  /** From the program text to moves, stock, proof and times. `atStage` is told what it begins. */
  update(
    { version, text, name, files = [], skipMarked = false, table, rapid, control }: Request,
    atStage: (stage: Stage) => void = () => undefined,
  ): Outcome {
    atStage("reading");
    const program = parse(text);
    atStage("running");
    const beside = filesByName(name === undefined ? files : [{ name, text }, ...files], parse);
    const taken = new Set([program]);
    const find = (key: string) => {
      const found = beside.find(key);
      if (found) taken.add(found.program);
      return found;
    };
    const made = run(program, { ...table, rapid, control, files: { find }, skipMarked, tracing });
    atStage("proving");
    const simulation = simulate(made);
    const marked = [...taken].some(({ blocks }) => blocks.some(({ skip }) => skip));
    return { version, text, marked, run: made, simulation };
  },

  /** What each tool can do with the values of a job, best first; null while they make no contour. */
  fits(job: SetJob, { start, feedUnit, tools }: Circumstances): readonly ToolFit[] | null {
    const cycle = cycleByNumber(job.cycle);
    const values = cycle && readDraft(cycle, job.drafts[job.cycle] ?? {}, knownParameters(job)).values;
    if (!cycle || !values) return null;
    const given = givenOf({ cycle, job });
    if (cycle.outline(values, given).issues.some((found) => found.severity === "error")) return null;
    return rankTools(cycle, values, given, { start, feedUnit, autoFeed: null, stock: null }, tools);
  },

  /** What each tool can do in place of the one that was called, best first; null while the call makes no contour. */
  fitsOfCall({ cycle: number, call, feedUnit }: Called, tools: readonly Tool[]): readonly ToolFit[] | null {
    const cycle = cycleByNumber(number);
    if (!cycle || !call) return null;
    return rankTools(cycle, call.values, call.given, { start: call.start, feedUnit, autoFeed: call.autoFeed, stock: null }, tools);
  },
};
