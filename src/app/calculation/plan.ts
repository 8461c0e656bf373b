import { parse } from "../../nc/parse.ts";
import type { Program } from "../../nc/program.ts";
import { incrementalParser } from "../../nc/reread.ts";
import { AnswerCache } from "../../kernel/answer-cache.ts";
import { never } from "../../kernel/never.ts";
import type { Run } from "../../program/state/run-types.ts";
import type { Shop } from "../../program/state/shop.ts";
import { filesByName } from "../../program/state/program-files.ts";
import { run } from "../../program/run/run.ts";
import { incrementalRunner } from "../../program/run/incremental-run.ts";
import { traceStock } from "../../sim/tracing.ts";
import type { AtStage, Planned } from "./outcome.ts";
import type { Request } from "./request.ts";

/** The parser, and what may be known of previous runs. */
interface By extends Pick<Shop, "tracing" | "memory"> {
  readonly read: (text: string) => Program;
}
const FRESH: By = { tracing: traceStock, read: parse };

/** Reads a request and runs it; null if the run is not finished. */
function planBy(
  request: Request,
  atStage: AtStage,
  { read, ...known }: By,
  runs: (program: Program, shop: Shop, beside: NonNullable<Request["files"]>) => Run | null,
): Planned | null {
  const { version, text, name, files = [], skipMarked = false, table, rapid, control, machine } = request;
  atStage("reading");
  const program = read(text);
  atStage("running");
  const beside = filesByName(name === undefined ? files : [{ name, text }, ...files], parse);
  const taken = new Set([program]);
  const find = (key: string) => {
    const found = beside.find(key);
    if (found) taken.add(found.program);
    return found;
  };
  const made = runs(
    program,
    { ...table, rapid, control, files: { find }, skipMarked, ...(machine && { machine }), ...known },
    files,
  );
  const marked = [...taken].some(({ blocks }) => blocks.some(({ skip }) => skip));
  return made && { version, text, marked, run: made, simulation: null };
}

const silent = () => undefined;

/** From the program text to its moves, for page and worker alike. `atStage` is called as each stage begins. */
export const planned = (request: Request, atStage: AtStage = silent): Planned =>
  planBy(request, atStage, FRESH, run) ?? never("a run without an end", request);

/** Plans successive states of a work. */
interface Planner {
  (request: Request, atStage?: AtStage): Planned;
  /**
   * Continues planning a request while `continuesStep` returns true at each point where it can pause; null until it is
   * finished.
   */
  readonly part: (request: Request, goesOn: () => boolean) => Planned | null;
}

/**
 * A planner for one work: unchanged blocks are not parsed again, nothing before the first change is run again, and
 * unchanged cycles are not planned again. The result equals that of `planned`.
 */
export function planner(memory = new AnswerCache()): Planner {
  const runs = incrementalRunner();
  const by: By = { memory, tracing: traceStock, read: incrementalParser() };
  const ended = <Made extends Planned | null>(made: Made): Made => {
    if (made) memory.runEnded();
    return made;
  };
  const whole = (request: Request, atStage: AtStage = silent) =>
    ended(planBy(request, atStage, by, runs)) ?? never("a run without an end", request);
  return Object.assign(whole, {
    part: (request: Request, goesOn: () => boolean) =>
      ended(planBy(request, silent, by, (program, shop, beside) => runs.interruptible(program, shop, beside, goesOn))),
  });
}
