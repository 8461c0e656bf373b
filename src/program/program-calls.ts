import type { FileName, StatementOf } from "../nc/statement.ts";
import { programIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";
import type { ContourSource } from "./modal.ts";
import type { Unit } from "./units.ts";

/** The older cycle that names a program, which a cycle call then runs. */
export const PROGRAM_CYCLE = 12;

/** Nobody knows what the called program does: not where it leaves the tool, and not what it cuts. */
function lost(machine: Machine, what: string, index: number): void {
  machine.loseAll();
  machine.log.leaveUnproved(what, index);
}

/** Runs the program of a name next, or says that it is not at hand. */
export function callNamed(machine: Machine, name: string | null, what: string, index: number): void {
  if (name === null) return lost(machine, what, index);
  const unit = machine.unitOfFile(name, index);
  if (unit) machine.next = unit;
  else {
    machine.log.say(programIssue("programNotOpened", "info", { file: name }), index);
    lost(machine, what, index);
  }
}

export const callProgram = (machine: Machine, s: StatementOf<"callProgram">, index: number): void =>
  callNamed(machine, machine.fileName(s.file, index), "CALL PGM", index);

/** SEL PGM: the name counts from here on, also one that nobody knows. */
export const selectProgram = (machine: Machine, s: StatementOf<"selectProgram">, index: number): void =>
  machine.set({ selectedProgram: { name: machine.fileName(s.file, index) } });

export function callSelected(machine: Machine, index: number): void {
  const selected = machine.now.selectedProgram;
  if (selected) callNamed(machine, selected.name, "CALL SELECTED PGM", index);
  else machine.log.say(programIssue("programNotSelected", "error", {}), index);
}

/** The second line of cycle 12 names the program: `PGM TNC:\DRILL.H`, or the name alone. */
export function programCycle(machine: Machine, { line, text }: StatementOf<"cycleLine">, index: number): void {
  if (line !== 1) return;
  const name = text.replace(/^PGM[ \t]+/i, "").replaceAll('"', "").trim();
  const program = /^QS\d{1,4}$/i.test(name) ? machine.text(name.toUpperCase(), index) : name;
  machine.set({ callsBehindMoves: false, defined: { index, cycle: PROGRAM_CYCLE, values: new Map(), troubled: new Set(), program } });
}

const DECLARED = /^DECLARE[ \t]+CONTOUR[ \t]+QC\d+[ \t]*=[ \t]*(?:"([^"]+)"|LBL[ \t]*(?:(\d{1,9})|"([^"]+)"))/i;

/** The contours of a file: the file is one, or it declares the one that counts. Several, joined by a formula, are not read. */
function contoursOf(machine: Machine, unit: Unit, index: number): readonly ContourSource[] | "unknown" {
  const declared = unit.program.blocks.flatMap(({ statement: s }) => {
    const m = s.kind === "unknown" ? DECLARED.exec(s.text) : null;
    return m ? [m] : [];
  });
  const [only] = declared;
  if (!only) return [{ unit, label: null }];
  if (declared.length > 1) return "unknown";
  const [, file, digits, name] = only;
  if (file === undefined) return [{ unit, label: digits === undefined ? (name ?? "") : Number(digits) }];
  const named = machine.unitOfFile(file, index);
  return named ? [{ unit: named, label: null }] : "unknown";
}

/** Takes the contour of a file that is at hand; else the cycle that needs it says that it is missing. */
function takeFile(machine: Machine, file: FileName, what: string, index: number): void {
  const name = machine.fileName(file, index);
  if (name === null) return machine.set({ contours: "unknown", contourFile: null });
  const unit = machine.unitOfFile(name, index);
  if (unit) return machine.set({ contours: contoursOf(machine, unit, index), contourFile: null });
  machine.set({ contours: [], contourFile: name });
  machine.log.notSimulated(`${what} "${name}"`, index, "warning");
}

export const selectContour = (machine: Machine, s: StatementOf<"selectContour">, index: number): void =>
  takeFile(machine, s.file, "SEL CONTOUR", index);

/** CONTOUR DEF: one area is a contour; how several of them make one is not read. */
export function contourDefinition(machine: Machine, { areas }: StatementOf<"contourDefinition">, index: number): void {
  const [area] = areas;
  if (!area || areas.length > 1) return machine.set({ contours: "unknown", contourFile: null });
  if ("file" in area.from) return takeFile(machine, area.from.file, "CONTOUR DEF", index);
  const { label: named } = area.from;
  const label = typeof named !== "object"
    ? named
    : named.parameter.startsWith("QS")
    ? machine.text(named.parameter, index)
    : machine.number(named, index);
  machine.set({ contours: label === null ? "unknown" : [{ unit: machine.unit, label }], contourFile: null });
}
