import type { Program } from "../../nc/program.ts";
import { isRefused, retooledOperation } from "../../program/edits/operation-edits.ts";
import { operationAt, operationsOf } from "../../program/edits/operations.ts";
import { withTool } from "../../app/fields/blocks/repairs.ts";
import { editProgram } from "../../app/fields/blocks/session.ts";

/** Calls another tool for the operation of a cycle, whose block stays open. Where it cannot be separated, its call changes. */
export function retoolBlock(program: Program, index: number, T: number): void {
  const unit = operationAt(program, index) ?? -1;
  const nth = operationsOf(program).units[unit]?.definitions.indexOf(index) ?? -1;
  const made = nth < 0 ? null : retooledOperation(program, unit, T);
  if (!made || isRefused(made)) editProgram(withTool(program, index, T), null);
  else editProgram(made, null, operationsOf(made).units[unit]?.definitions[nth] ?? null);
}
