import { parse } from "../../nc/parse.ts";
import { filesByName } from "../../program/program-files.ts";
import { run } from "../../program/run.ts";
import { tracing } from "../../sim/tracing.ts";
import type { Planned, Stage } from "./outcome.ts";
import type { Request } from "./request.ts";

/** From the program text to its moves: what the page and the worker do alike. `atStage` is told what it begins. */
export function planned(request: Request, atStage: (stage: Stage) => void = () => undefined): Planned {
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
  const made = run(program, { ...table, rapid, control, files: { find }, skipMarked, tracing });
  const marked = [...taken].some(({ blocks }) => blocks.some(({ skip }) => skip));
  return { version, text, marked, run: made, simulation: null };
}
