import { fileKey } from "../../program/state/program-files.ts";
import { cachedMachine } from "./machine-reader.ts";
import { openReading } from "../document/reading.ts";
import { openContent, useEditor } from "../document/store.ts";
import { isProgram } from "../document/work.ts";
import { controlInUse, machineInUse, toolTable } from "../document/work-tools.ts";
import type { CalculationInput } from "./calculation-state.ts";
import { runOf } from "./request.ts";

/** Input of the calculation from the open work; null if no work is open, or its cycle is unknown. */
export function currentCalculationInput(): CalculationInput | null {
  const content = openContent();
  const read = openReading();
  if (!content || (!read && !isProgram(content))) return null;
  const of = `${useEditor.getState().work} ${isProgram(content) ? fileKey(content.name) : content.cycle}`;
  const isVeiled = content.task?.veiled ?? false;
  // A whole program is always calculated, also with errors.
  if (read && !read.reading.values) return { of, isVeiled, request: null };
  const machine = cachedMachine(machineInUse());
  if (machine === undefined) return { of, isVeiled };
  return { of, isVeiled, request: { ...runOf(content), table: toolTable(), control: controlInUse(), machine } };
}
