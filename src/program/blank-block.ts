import { axial, length } from "../kernel/units.ts";
import type { StatementOf, Value } from "../nc/statement.ts";
import { cylinder, measured, rotation } from "./blank-form.ts";
import { readContour } from "./contour-subprogram.ts";
import { programIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";

/** BLK FORM 0.1 and 0.2: only the upper side is taken, for the approaches of a mill. */
export function blankBox(machine: Machine, s: StatementOf<"blankBox">, index: number): void {
  const word = s.corner === 2 ? s.axes.find((w) => w.axis === "Z") : undefined;
  const n = word ? machine.number(word.value, index) : null;
  if (n !== null) machine.setMill({ top: machine.length(n) });
  if (machine.now.turning) machine.log.say(programIssue("blankNotTurned", "info", { form: "BLK FORM 0.1" }), index);
}

export function blankCylinder(machine: Machine, s: StatementOf<"blankCylinder">, index: number): void {
  const read = (v: Value | null) => {
    const n = v === null ? null : machine.number(v, index);
    return n === null ? null : machine.length(n);
  };
  const [outside, inside] = [read(s.outside?.value ?? null), read(s.inside?.value ?? null)];
  const [long, distance] = [read(s.length), read(s.distance)];
  if (outside === null || long === null) return machine.log.say(programIssue("blankImpossible", "error", {}), index);
  const rings = cylinder({
    outside: measured(outside, s.outside?.measure === "D"),
    inside: measured(inside ?? 0, s.inside?.measure === "DI"),
    length: length(long),
    front: axial(distance ?? 0),
  });
  if (rings) machine.set({ blank: rings });
  else machine.log.say(programIssue("blankImpossible", "error", {}), index);
}

/** The blank that a label outlines; `radii`: its X words are radii. */
export function outlinedBlank(machine: Machine, label: number | string, radii: boolean, index: number): void {
  const read = readContour(machine, label, index, radii);
  if (!read) return;
  for (const i of read.contour.issues) machine.log.say(i, read.blocks["element" in i.data ? i.data.element - 1 : 0] ?? index);
  const rings = rotation(read.contour.segments);
  if (rings) machine.set({ blank: rings });
  else machine.log.say(programIssue("blankImpossible", "error", {}), index);
}

/** FUNCTION TURNDATA BLANK: the outline in a label is the stock where the program has no blank; air cuts are not left out. */
export function blankOfTurnData(machine: Machine, s: StatementOf<"turnBlank">, index: number): void {
  if (s.blank === "off") return;
  if ("file" in s.blank) return machine.log.leaveUnproved(`FUNCTION TURNDATA BLANK "${s.blank.file}"`, index);
  const first = machine.now.blank.length === 0;
  if (first) outlinedBlank(machine, s.blank.label, false, index);
  const label = String(s.blank.label);
  if (!first) machine.log.say(programIssue("blankNotTaken", "info", { label }), index);
  else if (machine.now.blank.length > 0) machine.log.say(programIssue("blankTaken", "info", { label }), index);
}
