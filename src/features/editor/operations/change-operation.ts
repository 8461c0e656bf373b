import type { Program } from "../../../nc/program.ts";
import {
  duplicatedOperation,
  isRefused,
  movedOperation,
  retooledOperation,
  switchedOperation,
  withoutOperation,
  type Refusal,
} from "../../../program/edits/operation-edits.ts";
import { finishedOperation } from "../../../program/edits/finishing-operation.ts";
import { isOff, operationsOf } from "../../../program/edits/operations.ts";
import { editProgram, useSession } from "../../../app/fields/blocks/session.ts";
import { asOneStep } from "../../../app/document/steps.ts";
import { changeProgram, useEditor } from "../../../app/document/store.ts";
import { openingBlock } from "../../../app/fields/blocks/operation-rows.ts";

const present = (): Program => useSession.getState().reading.program;

/** Applies an edited program as one step of undo, with an operation open; a refusal changes nothing. */
function applyProgram(next: Program | Refusal, unit: number): Refusal | null {
  if (isRefused(next)) return next;
  editProgram(next, null, openingBlock(next, unit));
  return null;
}

export const moveOperation = (unit: number, to: number): Refusal | null =>
  applyProgram(movedOperation(present(), unit, to), to);
export const duplicateOperation = (unit: number): Refusal | null =>
  applyProgram(duplicatedOperation(present(), unit), unit + 1);
export const removeOperation = (unit: number): Refusal | null =>
  applyProgram(withoutOperation(present(), unit), Math.max(0, unit - 1));
export const retoolOperation = (unit: number, tool: number): Refusal | null =>
  applyProgram(retooledOperation(present(), unit, tool), unit);

export const finishOperation = (unit: number, tool: number): Refusal | null =>
  applyProgram(finishedOperation(present(), unit, tool), unit + 1);

/** Toggles the skip marks of an operation. They only act with their switch on, so both are one step. */
export function switchOperation(unit: number): Refusal | null {
  const program = present();
  const own = operationsOf(program).units[unit];
  if (!own) return null;
  const on = isOff(program, own);
  const next = switchedOperation(program, unit, on);
  if (isRefused(next) || on || useEditor.getState().program?.skipMarked) return applyProgram(next, unit);
  return asOneStep(() => {
    changeProgram((work) => ({ ...work, skipMarked: true }));
    return applyProgram(next, unit);
  });
}
