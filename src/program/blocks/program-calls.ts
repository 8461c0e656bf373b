import { PROGRAM_CYCLE } from "../../nc/blocks/cycle-line.ts";
import { writtenFile } from "./assign.ts";
import type { StatementOf } from "../../nc/statement.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";
import { nameInCycle } from "../state/program-files.ts";

/** The effect of the called program is unknown: neither its cuts nor the tool position after it. */
function lost(machine: Machine, what: string, index: number): void {
  machine.losePosition();
  machine.log.leaveUnproved(what, index);
}

/** Runs the named program next, or reports that it was not opened. */
export function callNamed(machine: Machine, name: string | null, what: string, index: number): void {
  if (name === null) return lost(machine, what, index);
  const unit = machine.unitOfFile(name, index);
  if (unit) machine.change({ enters: unit });
  else {
    machine.log.report(programIssue("programNotOpened", "info", { file: name }), index);
    lost(machine, what, index);
  }
}

export const callProgram = (machine: Machine, s: StatementOf<"callProgram">, index: number): void =>
  callNamed(machine, writtenFile(machine, s.file, index), "CALL PGM", index);

/** SEL PGM: the name counts from here on, even when unknown. */
export const selectProgram = (machine: Machine, s: StatementOf<"selectProgram">, index: number): void =>
  machine.set({ selectedProgram: { name: writtenFile(machine, s.file, index) } });

export function callSelected(machine: Machine, index: number): void {
  const selected = machine.now.selectedProgram;
  if (selected) callNamed(machine, selected.name, "CALL SELECTED PGM", index);
  else machine.log.report(programIssue("programNotSelected", "error", {}), index);
}

/** The second line of cycle 12 names the program. */
export function programCycle(machine: Machine, { line, text }: StatementOf<"cycleLine">, index: number): void {
  if (line !== 1) return;
  const name = nameInCycle(text);
  const program = /^QS\d{1,4}$/i.test(name) ? machine.text(name.toUpperCase(), index) : name;
  machine.set({
    callsBehindMoves: false,
    defined: { index, cycle: PROGRAM_CYCLE, values: new Map(), unknownParameters: new Set(), program },
  });
}
