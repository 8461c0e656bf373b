import type { Operation } from "../../../program/state/run-types.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { isDefinedIn } from "../../document/shown-findings.ts";
import { useShownOtherFile } from "../../document/shown-file.ts";

/** Index of the thread operation whose cycle is defined in this line of a file, or the one of a job; −1 for none. */
export const indexOfThread = (operations: readonly Operation[], line: number | null, file: string | null): number =>
  operations.findIndex((o) => o.plan.thread && (line === null || (o.definedLine === line && isDefinedIn(o, file))));

/** The calculated operation of the thread cycle in this program line, or of the job without a line; null without one. */
export function useThreadOperation(line: number | null): Operation | null {
  const shown = useOutcome((s) => s.pictured);
  const file = useShownOtherFile();
  const operations = shown?.run.operations ?? [];
  return operations[indexOfThread(operations, line, file)] ?? null;
}
