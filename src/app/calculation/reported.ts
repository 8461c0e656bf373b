import { parse } from "../../nc/parse.ts";
import { report } from "../../report/report.ts";
import { usedTools, type CalledAs } from "../../report/used-tools.ts";
import { engine } from "./engine.ts";
import type { Request } from "./request.ts";

/** What a work comes to, to be compared with what it comes to elsewhere. */
export interface Reported {
  /** The report as `verify --json` prints it, with no times of the calculation: the same work gives the same text. */
  readonly text: string;
  /** The tools that it takes to come to it; null where that cannot be told. */
  readonly used: readonly CalledAs[] | null;
}

const NO_TIME = { parse: 0, plan: 0, simulate: 0 };

/** The report on a program. Runs in the worker, which fetches it when it is first asked for. */
export function reported(request: Request, file: string): Reported {
  const { run, simulation } = engine.update(request);
  const made = report({ file, run, simulation, milliseconds: NO_TIME, tools: request.table.tools }, "en");
  const programs = [request.text, ...(request.files ?? []).map(({ text }) => text)].map(parse);
  return { text: `${JSON.stringify(made)}\n`, used: usedTools(programs, made) };
}
