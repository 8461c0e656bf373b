import { parse } from "../../nc/parse.ts";
import type { Program } from "../../nc/program.ts";
import { readingAgain } from "../../nc/reread.ts";
import type { Shop } from "../../program/shop.ts";
import { planMemory } from "../../program/plan-memory.ts";
import { filesByName } from "../../program/program-files.ts";
import { run } from "../../program/run.ts";
import { runningAgain } from "../../program/run-again.ts";
import { tracing } from "../../sim/tracing.ts";
import { tracingAgain } from "../../sim/tracing-again.ts";
import type { Planned, Stage } from "./outcome.ts";
import type { Request } from "./request.ts";

/** What reads and runs, and what may be known of runs before. */
interface By extends Pick<Shop, "tracing" | "memory"> {
  readonly read: (text: string) => Program;
  readonly run: ReturnType<typeof runningAgain>;
}
const FRESH: By = { tracing, read: parse, run };

/** From the program text to its moves: what the page and the worker do alike. `atStage` is told what it begins. */
export function planned(request: Request, atStage: (stage: Stage) => void = () => undefined, by = FRESH): Planned {
  const { version, text, name, files = [], skipMarked = false, table, rapid, control } = request;
  atStage("reading");
  const { read, run: runs, ...known } = by, program = read(text);
  atStage("running");
  const beside = filesByName(name === undefined ? files : [{ name, text }, ...files], parse);
  const taken = new Set([program]);
  const find = (key: string) => {
    const found = beside.find(key);
    if (found) taken.add(found.program);
    return found;
  };
  const made = runs(program, { ...table, rapid, control, files: { find }, skipMarked, ...known }, files);
  const marked = [...taken].some(({ blocks }) => blocks.some(({ skip }) => skip));
  return { version, text, marked, run: made, simulation: null };
}

/**
 * Plans one state of a work after the other: blocks that stay the same are not read again, what comes before the first that is another is
 * not run again, and cycles that stay the same are not planned again. What comes is the same as of `planned`.
 */
export function planner(): (request: Request, atStage?: (stage: Stage) => void) => Planned {
  const [memory, traced, read, runs] = [planMemory(), tracingAgain(), readingAgain(), runningAgain()];
  return (request, atStage) => {
    memory.next();
    traced.next();
    return planned(request, atStage, { memory, tracing: traced.tracing, read, run: runs });
  };
}
