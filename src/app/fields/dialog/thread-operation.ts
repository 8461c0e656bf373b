import type { Operation } from "../../../program/state/run-types.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { isDefinedIn } from "../../document/shown-findings.ts";
import { useShownOtherFile } from "../../document/shown-file.ts";

/** The calculated operation of the thread cycle in this program line, or of the job without a line; null without one. */
export function useThreadOperation(line: number | null): Operation | null {
  const shown = useOutcome((s) => s.pictured);
  const file = useShownOtherFile();
  const isMeant = (o: Operation) => line === null || (o.definedLine === line && isDefinedIn(o, file));
  return shown?.run.operations.find((o) => o.plan.thread && isMeant(o)) ?? null;
}
