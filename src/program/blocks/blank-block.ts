import { writtenFile } from "./assign.ts";
import type { Cuboid } from "../../kernel/area/box.ts";
import { difference } from "../../kernel/area/clip.ts";
import { issue } from "../../kernel/plan/issue.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { areaOutside } from "../../kernel/area/real-area.ts";
import { axial, length, toDiameter } from "../../kernel/units.ts";
import type { StatementOf } from "../../nc/statement.ts";
import type { AxisName, FileName, Label, OutlineSource, Value } from "../../nc/words.ts";
import { boxBetween, cylinder, measured, rotation, turnedBox, type BoxCorner } from "../state/blank-form.ts";
import { readContourOf } from "./contour-subprogram.ts";
import { valueOf } from "../values/formula.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";
import type { ContourSource } from "../state/modal.ts";
import { traceBlank } from "./stock-at-call.ts";

const impossible = (machine: Machine, index: number): void =>
  machine.log.report(programIssue("blankImpossible", "error", {}), index);

const now = ({ log }: Machine) => ({ operations: log.operations.length, steps: log.steps.length });

/** A called program repeats its blank: the blank of its caller counts. */
function isOfCaller(machine: Machine): boolean {
  const { blankIn } = machine.now;
  if (blankIn === undefined) machine.set({ blankIn: machine.unit.file });
  return blankIn !== undefined && blankIn !== machine.unit.file;
}

/**
 * Uses a body of revolution about the spindle axis as the blank; one about another axis is reported when turning
 * starts.
 */
function take(machine: Machine, rings: readonly Ring[] | null, axis: AxisName, index: number): void {
  if (isOfCaller(machine)) return;
  if (!rings) return impossible(machine, index);
  if (axis === "Z") return machine.set({ blank: rings, blankSince: now(machine), nonTurnedBlank: null });
  machine.set({ blank: [], nonTurnedBlank: { kind: "otherAxis", index, form: `BLK FORM … ${axis}` } });
  if (machine.now.turning) turnBlank(machine);
}

const NOTHING: BoxCorner = { x: null, y: null, z: null };

/**
 * BLK FORM 0.1 and 0.2. Milling approaches need the upper side. A value without a number is reported only where the
 * program needs it: there, or when turning starts.
 */
export function blankBox(machine: Machine, s: StatementOf<"blankBox">, index: number): void {
  const top = s.corner === 2 ? s.axes.find((w) => w.axis === "Z") : undefined;
  const n = top ? machine.number(top.value, index) : null;
  if (n !== null) machine.setMill({ top: machine.length(n) });
  if (isOfCaller(machine)) return;
  const { nonTurnedBlank } = machine.now;
  const first = s.corner === 2 && nonTurnedBlank?.kind === "box" ? nonTurnedBlank.corners[0] : NOTHING;
  const along = (axis: "X" | "Y" | "Z", before: number | null): number | null => {
    const word = s.axes.find((w) => w.axis === axis);
    const value = word && valueOf(word.value, machine.parameters);
    if (!word || typeof value !== "number") return null;
    return word.incremental ? before && before + machine.length(value) : machine.length(value);
  };
  const corner: BoxCorner = { x: along("X", first.x), y: along("Y", first.y), z: along("Z", first.z) };
  machine.set({
    blank: [],
    nonTurnedBlank: { kind: "box", index, corners: s.corner === 1 ? [corner, NOTHING] : [first, corner] },
  });
  if (machine.now.turning && s.corner === 2) turnBlank(machine);
}

/** Box of the blank; null for other forms, and where a corner is unknown. */
export function cuboidOf({ now: { nonTurnedBlank } }: Machine): Cuboid | null {
  const box = nonTurnedBlank?.kind === "box" ? boxBetween(...nonTurnedBlank.corners) : null;
  return typeof box === "string" ? null : box;
}

export function blankCylinder(machine: Machine, s: StatementOf<"blankCylinder">, index: number): void {
  const read = (v: Value | null) => {
    const n = v === null ? null : machine.number(v, index);
    return n === null ? null : machine.length(n);
  };
  const [outside, inside] = [read(s.outside?.value ?? null), read(s.inside?.value ?? null)];
  const [long, distance] = [read(s.length), read(s.distance)];
  if (!s.outside || s.length === null) return impossible(machine, index);
  // A value without a number is reported already.
  if (outside === null || long === null || (s.inside && inside === null) || (s.distance !== null && distance === null))
    return;
  const rings = cylinder({
    outside: measured(outside, s.outside.measure === "D"),
    inside: measured(inside ?? 0, s.inside?.measure === "DI"),
    length: length(long),
    front: axial(distance ?? 0),
  });
  take(machine, rings, s.axis, index);
}

/** BLK FORM ROTATION: body of revolution of an outline, minus an inner outline. */
export function blankRotation(machine: Machine, s: StatementOf<"blankRotation">, index: number): void {
  if (isOfCaller(machine)) return;
  const radii = s.measure === "R";
  const missing = "file" in s.outline ? missingFile(machine, s.outline.file, index) : null;
  if (missing !== null) return unread(machine, `BLK FORM ROTATION "${missing}"`, index);
  const outer = outlined(machine, s.outline, { radii, what: "BLK FORM ROTATION" }, index);
  const inner = s.inner === null ? [] : behindLabel(machine, s.inner, radii, index);
  if (s.inner !== null) machine.log.report(programIssue("wordsRecalled", "info", { what: "LBLIN" }), index);
  if (outer === "unread" || inner === "unread") return;
  const rings = outer && inner && difference(outer, inner);
  take(machine, rings && rings.length > 0 ? rings : null, s.axis, index);
}

/** BLK FORM FILE: the body is not read, so a program that turns stays unverified. */
export function blankFile(machine: Machine, s: StatementOf<"blankFile">, index: number): void {
  if (isOfCaller(machine)) return;
  unread(machine, `BLK FORM FILE "${s.file}"`, index);
}

/** A blank from a file that is not read: turning with it is unverified. */
function unread(machine: Machine, form: string, index: number): void {
  machine.set({ blank: [], nonTurnedBlank: { kind: "file", index, form } });
  if (machine.now.turning) turnBlank(machine);
}

/**
 * Name of a file that was not opened with the program, after reporting it; null when it was opened or the name is
 * unknown.
 */
function missingFile(machine: Machine, named: FileName, index: number): string | null {
  const file = writtenFile(machine, named, index);
  if (file === null || machine.unitOfFile(file, index)) return null;
  machine.log.report(programIssue("programNotOpened", "info", { file }), index);
  return file;
}

/** An outline of FUNCTION TURNDATA defines the turning blank, so the form of BLK FORM does not matter. */
const statesOutline = ({ input: { program } }: Machine) =>
  program.blocks.some(({ statement: s }) => s.kind === "turnBlank" && s.blank !== "off");

/** Turning starts: chooses the stock for a blank of another form, and reports it at the block of that blank. */
export function turnBlank(machine: Machine): void {
  const { blank, nonTurnedBlank } = machine.now;
  if (blank.length > 0 || !nonTurnedBlank) return;
  const { index } = nonTurnedBlank;
  const made = nonTurnedBlank.kind === "box" ? turnedBox(...nonTurnedBlank.corners) : nonTurnedBlank.kind;
  if (typeof made !== "string") return machine.set({ blank: made.rings, blankSince: now(machine) });
  if (made === "impossible") return impossible(machine, index);
  if (statesOutline(machine)) return;
  const form = nonTurnedBlank.kind === "box" ? "BLK FORM 0.1" : nonTurnedBlank.form;
  if (made === "file" || made === "unknown") machine.log.leaveUnproved(form, index);
  else machine.log.report(programIssue("blankNotTurned", "info", { form }), index);
}

/** Reports a cycle call without a blank, unless the cause is reported already. */
export function reportMissingBlank({ log }: Machine): void {
  if (!log.unproved.slice().some((u) => u.what.startsWith("BLK FORM")))
    log.report(programIssue("blankMissing", "warning", {}), null);
}

/** Reports that a box is used as the stock, unless an outline replaced it before the first cut. */
export function reportTurnedBox(machine: Machine): void {
  const { blank, nonTurnedBlank } = machine.now;
  const made = nonTurnedBlank?.kind === "box" && blank.length > 0 ? turnedBox(...nonTurnedBlank.corners) : null;
  if (!nonTurnedBlank || !made || typeof made === "string") return;
  machine.log.report(
    programIssue("boxTurned", "warning", { outer: toDiameter(made.outer), inner: toDiameter(made.inner) }),
    nonTurnedBlank.index,
  );
}

/** Rings of an outline; null: no area; "unread": the missing part is reported already. */
type Outlined = Ring[] | null | "unread";

function outlineRings(machine: Machine, source: ContourSource, radii: boolean, index: number): Outlined {
  const read = readContourOf(machine, source, index, radii);
  if (!read) return "unread";
  for (const i of read.contour.issues)
    machine.log.report(i, read.blocks["element" in i.data ? i.data.element - 1 : 0] ?? index);
  return rotation(read.contour.segments);
}

const behindLabel = (machine: Machine, label: Label, radii: boolean, index: number): Outlined =>
  outlineRings(machine, { unit: machine.unit, label }, radii, index);

/** An outline behind a label or in a file; `radii`: X words are radii. A missing file leaves `what` unverified. */
function outlined(
  machine: Machine,
  from: OutlineSource,
  { radii, what }: { readonly radii: boolean; readonly what: string },
  index: number,
): Outlined {
  if ("label" in from) return behindLabel(machine, from.label, radii, index);
  const missing = missingFile(machine, from.file, index);
  const file = missing === null ? writtenFile(machine, from.file, index) : null;
  const unit = file === null ? null : machine.unitOfFile(file, index);
  if (unit) return outlineRings(machine, { unit, label: null }, radii, index);
  machine.log.leaveUnproved(missing === null ? what : `${what} "${missing}"`, index);
  return "unread";
}

/** Source of an outline, as a program spells it. */
function sourceName(machine: Machine, from: OutlineSource, index: number): string {
  if ("file" in from) return `"${writtenFile(machine, from.file, index) ?? ""}"`;
  return `LBL ${typeof from.label === "number" ? from.label : `"${from.label}"`}`;
}

/** FUNCTION TURNDATA BLANK: from here on the stock is the outline in a label or a file. */
export function blankOfTurnData(machine: Machine, { blank }: StatementOf<"turnBlank">, index: number): void {
  if (blank === "off") return void machine.change({ traced: null });
  const what = "FUNCTION TURNDATA BLANK";
  // Milling updates no blank.
  if (!machine.now.turning) return machine.log.notSimulated(what, index);
  const rings = outlined(machine, blank, { radii: false, what }, index);
  if (rings === "unread") return;
  if (!rings) return impossible(machine, index);
  const named = `${what} ${sourceName(machine, blank, index)}`;
  const before = machine.now.blank;
  // A box is only an upper limit of the material.
  const stated = before.length > 0 && machine.now.nonTurnedBlank === null;
  machine.log.report(programIssue("blankTraced", "info", {}), index);
  if (machine.log.steps.slice().some((s) => s.move.kind !== "rapid")) {
    reportTurnedBox(machine);
    if (before.length === 0) machine.log.leaveUnproved(named, index);
    machine.log.noteBlank(rings, { what: named, before }, index);
  } else compare(machine, { before, rings, stated, named }, index);
  machine.set({ blank: rings, blankSince: now(machine), nonTurnedBlank: null });
  traceBlank(machine, rings);
}

interface Compared {
  readonly before: readonly Ring[];
  readonly rings: readonly Ring[];
  readonly stated: boolean;
  readonly named: string;
}

/** Nothing is cut yet: the outline is the blank. Material that only BLK FORM has stays unverified. */
function compare(machine: Machine, { before, rings, stated, named }: Compared, index: number): void {
  const [lacks, adds] = [stated ? areaOutside(before, rings) : 0, areaOutside(rings, before)];
  if (!stated) machine.log.report(programIssue("blankTaken", "info", { what: named }), index);
  if (lacks > 0) {
    machine.log.report(issue("blankLacks", "warning", { what: named, area: lacks }), index);
    machine.log.leaveUnproved(named, index);
  }
  if (before.length > 0 && adds > 0)
    machine.log.report(programIssue("blankAdds", "warning", { what: named, area: adds }), index);
}
