import { parse } from "../../nc/parse.ts";
import type { Shop } from "../../program/machine.ts";
import { planMemory } from "../../program/plan-memory.ts";
import { filesByName } from "../../program/program-files.ts";
import { run } from "../../program/run.ts";
import { tracing } from "../../sim/tracing.ts";
import { tracingAgain } from "../../sim/tracing-again.ts";
import type { Planned, Stage } from "./outcome.ts";
import type { Request } from "./request.ts";

/** What may be known of runs before. */
type Known = Pick<Shop, "tracing" | "memory">;

/** From the program text to its moves: what the page and the worker do alike. `atStage` is told what it begins. */
export function planned(request: Request, atStage: (stage: Stage) => void = () => undefined, known: Known = { tracing }): Planned {
  const { version, text, name, files = [], skipMarked = false, table, rapid, control } = request;
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
  const made = run(program, { ...table, rapid, control, files: { find }, skipMarked, ...known });
  const marked = [...taken].some(({ blocks }) => blocks.some(({ skip }) => skip));
  return { version, text, marked, run: made, simulation: null };
}

/** Plans one state of a work after the other: cycles that stay the same are not planned again. What comes is the same as of `planned`. */
export function planner(): (request: Request, atStage?: (stage: Stage) => void) => Planned {
  const [memory, traced] = [planMemory(), tracingAgain()];
  return (request, atStage) => {
    memory.next();
    traced.next();
    return planned(request, atStage, { memory, tracing: traced.tracing });
  };
}
