import { parse } from "../../nc/parse.ts";
import { report } from "../../report/report.ts";
import { usedTools, type CalledAs } from "../../report/used-tools.ts";
import { engine } from "./engine.ts";
import type { Request } from "./request.ts";

/** The report on a work, for comparison with that of another device. */
export interface Reported {
  /** The report as `verify --json` prints it, with no times of the calculation: the same work gives the same text. */
  readonly text: string;
  /** The tools that it uses; null if they are not known. */
  readonly used: readonly CalledAs[] | null;
}

const NO_TIME = { parse: 0, plan: 0, simulate: 0 };

/** The report on a program. Runs in the worker, which fetches this code on first use. */
export function reported(request: Request, file: string): Reported {
  const { run, simulation } = engine.update(request);
  const made = report({ file, run, simulation, milliseconds: NO_TIME, tools: request.table.tools }, "en");
  const programs = [request.text, ...(request.files ?? []).map(({ text }) => text)].map(parse);
  return { text: `${JSON.stringify(made)}\n`, used: usedTools(programs, made) };
}
