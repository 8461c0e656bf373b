import { loadMachine } from "./machine-reader.ts";
import { useEditor } from "../document/store.ts";
import { controlInUse, machineInUse, machineTextOf, shopOf, toolTable } from "../document/work-tools.ts";
import type { Comparer } from "./comparison.ts";
import type { ProgramWork, Work } from "../document/work.ts";
import type { Outcome } from "./outcome.ts";
import type { Reported } from "./reported.ts";
import { rapidOf, runOf, USUAL_RAPID, type Request } from "./request.ts";
import { askAgain } from "./worker-life.ts";

/*
 * Requests to the worker other than the calculation of the open work.
 */

/** The request for a program that is not open, with its own tools, machine and files. */
export async function requestOfOther(program: ProgramWork, timedAs = useEditor.getState().job): Promise<Request> {
  const machine = await loadMachine(machineTextOf(program));
  return { version: 0, ...runOf(program), ...shopOf(program), machine, ...(timedAs && { rapid: rapidOf(timedAs) }) };
}

/** The result of a program that is not open; null if it cannot be calculated. */
export async function outcomeOfOther(
  program: ProgramWork,
  timedAs = useEditor.getState().job,
): Promise<Outcome | null> {
  try {
    const request = await requestOfOther(program, timedAs);
    return await askAgain((engine) => engine.update(request));
  } catch {
    return null;
  }
}

/** The report on the open work in its present state, and the tools that it uses; null if it cannot be calculated. */
export async function reportOf(work: Work, file: string): Promise<Reported | null> {
  const shop = { version: 0, table: toolTable(), control: controlInUse(), machine: await loadMachine(machineInUse()) };
  try {
    const request = { ...shop, ...runOf(work) };
    return await askAgain((engine) => engine.reported(request, file));
  } catch {
    return null;
  }
}

/** The operations that could make a shape, and the result of each; null if it cannot be calculated. */
export const comparison: Comparer = {
  async ways(wanted, stock) {
    try {
      return await askAgain((engine) => engine.ways(wanted, stock, toolTable().tools));
    } catch {
      return null;
    }
  },
  async tryWay(proposal, wanted, stock) {
    const control = controlInUse();
    try {
      const shop = { table: toolTable(), rapid: USUAL_RAPID, control, machine: await loadMachine(machineInUse()) };
      return await askAgain((engine) => engine.tryWay(proposal, wanted, stock, shop));
    } catch {
      return null;
    }
  },
};
