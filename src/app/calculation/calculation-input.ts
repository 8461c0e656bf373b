import { fileKey } from "../../program/state/program-files.ts";
import { cachedMachine } from "./machine-reader.ts";
import { printedText } from "../document/printed.ts";
import { readJob } from "../document/reading.ts";
import { useEditor } from "../document/store.ts";
import { controlInUse, machineInUse, toolTable } from "../document/work-tools.ts";
import { filesOf } from "../document/work.ts";
import type { CalculationInput } from "./calculation-state.ts";
import { rapidOf, USUAL_RAPID } from "./request.ts";

/** Input of the calculation from the open work; null if no work is open, or its cycle is unknown. */
export function currentCalculationInput(): CalculationInput | null {
  const { job, program, work } = useEditor.getState();
  const read = job && readJob(job);
  const isVeiled = (job ?? program)?.task?.veiled ?? false;
  const machine = cachedMachine(machineInUse());
  const shop = () => ({ table: toolTable(), control: controlInUse(), machine: machine ?? null });
  if (program) {
    const { text, name, skipMarked = false } = program;
    const of = `${work} ${fileKey(name)}`;
    // A whole program is always calculated, also with errors.
    const request = () => ({ text, name, files: filesOf(program), skipMarked, rapid: USUAL_RAPID, ...shop() });
    return { of, isVeiled, ...(machine !== undefined && { request: request() }) };
  }
  if (!job || !read) return null;
  const of = `${work} ${job.cycle}`;
  if (!read.reading.values) return { of, isVeiled, request: null };
  if (machine === undefined) return { of, isVeiled };
  return { of, isVeiled, request: { text: printedText(job), rapid: rapidOf(job), ...shop() } };
}
