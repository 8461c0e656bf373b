import { contourFrom, type Contour, type ContourElement } from "../kernel/contour.ts";
import type { Pt } from "../kernel/point.ts";
import { axial, diameter, radius, toDiameter, toRadius } from "../kernel/units.ts";
import type { AxisWord, Label, Statement, Words } from "../nc/statement.ts";
import { programIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";
import { polarPoint } from "./polar.ts";
import { recessOf } from "./recess-words.ts";
import { nameOf } from "./unproved-blocks.ts";

/** A contour with the block each of its elements came from. */
export interface Subprogram {
  readonly contour: Contour;
  /** Index of the block of each element, in order. */
  readonly blocks: readonly number[];
  /** A block of it could not be read, which has been told. */
  readonly isTroubled: boolean;
}

interface Reader {
  readonly machine: Machine;
  readonly elements: ContourElement[];
  readonly blocks: number[];
  /** X in the measure of the contour: a diameter, or a radius for outlines in radii. */
  x: number | null;
  z: number | null;
  pole: Pt | null;
  readonly radii: boolean;
  /** A word that names the first point had no number. */
  isTroubled: boolean;
}

/** Longest contour that is read; beyond it the run ends, for a contour cut short would be another part. */
const MOST_BLOCKS = 20_000;

/** Reads the contour behind a label, up to LBL 0. Null when the label does not exist. `radii`: X words are radii (DIM_R). */
export function readContour(machine: Machine, label: Label, at: number, radii = false): Subprogram | null {
  const start = machine.labels.get(label);
  if (start === undefined) {
    machine.say(programIssue("labelMissing", "error", { label: String(label) }), at);
    return null;
  }
  const outer = new Map(machine.parameters);
  for (const name of [...machine.parameters.keys()]) if (name.startsWith("QL")) machine.parameters.delete(name);
  const reader: Reader = { machine, elements: [], blocks: [], x: null, z: null, pole: null, radii, isTroubled: false };
  let i = start + 1;
  for (; i < machine.blocks.length; i += 1) {
    machine.visited[i] = 1;
    const statement = machine.blocks[i]?.statement;
    if (!statement || (statement.kind === "label" && statement.label === 0) || statement.kind === "end") break;
    if (i - start > MOST_BLOCKS) machine.stop(programIssue("contourTooLong", "error", { limit: MOST_BLOCKS }), at);
    if (!machine.roomForBlock(at)) break;
    element(reader, statement, i);
  }
  const end = machine.blocks[i]?.statement;
  if (end?.kind !== "label" && !machine.full) machine.say(programIssue("labelNotClosed", "warning", { label: String(label) }), start);
  machine.parameters.clear();
  outer.forEach((value, name) => machine.parameters.set(name, value));
  if (machine.full) return null;
  return { contour: contourFrom(reader.elements), blocks: reader.blocks, isTroubled: reader.isTroubled };
}

/** A block as it is written, without its number. */
const lineOfBlock = (machine: Machine, index: number) => (machine.blocks[index]?.raw ?? "").trim().replace(/^\/?\d*[ \t]*\/?[ \t]*/, "");

function element(reader: Reader, s: Statement, index: number): void {
  switch (s.kind) {
    case "path": return path(reader, s.path, s.words, index);
    case "chamfer": return corner(reader, "chamfer", s.length === null ? null : reader.machine.number(s.length, index), index);
    case "assign": return reader.machine.assign(s, index);
    case "undercut": case "groove": {
      const recess = recessOf(reader.machine, s, index);
      if (!recess) return;
      reader.elements.push(recess);
      reader.blocks.push(index);
      return;
    }
    case "approach": case "call": case "cycleCall": case "jump": case "datum": case "unknown": return reader.machine.leaveUnproved(nameOf(lineOfBlock(reader.machine, index)), index);
    default: return;
  }
}

function corner(reader: Reader, kind: "chamfer" | "round", size: number | null, index: number): void {
  // Size 0 keeps the count of elements right where the size is missing.
  reader.elements.push({ kind, size: reader.machine.length(size ?? 0) });
  reader.blocks.push(index);
}

function path(reader: Reader, kind: Extract<Statement, { kind: "path" }>["path"], words: Words, index: number): void {
  const { machine } = reader;
  const value = (v: Words["radius"]) => (v === undefined ? null : machine.number(v, index));
  if (kind === "RND") return corner(reader, "round", value(words.radius), index);
  const polar = kind === "LP" || kind === "CP" || kind === "CTP";
  if (kind === "CC") {
    reader.pole = words.axes.length === 0 ? here(reader) : centre(reader, words.axes, index);
    return;
  }
  const from = here(reader);
  if (polar) {
    const to = reader.pole && polarPoint(reader.pole, from, words, (v) => machine.number(v, index), (n) => machine.length(n));
    if (!to) {
      reader.isTroubled = true;
      return machine.say(programIssue("poleMissing", "error", {}), index);
    }
    stand(reader, to);
  } else for (const w of words.axes) move(reader, w, index);
  const to = here(reader);
  if (!to) return incomplete(reader, index);
  const turn = words.turn ?? "ccw";
  const push = (e: ContourElement) => {
    reader.elements.push(e);
    reader.blocks.push(index);
  };
  switch (kind) {
    case "L": case "LP": return push({ kind: "line", to });
    case "CT": case "CTP": return push({ kind: "tangent", to });
    case "CR": {
      const r = value(words.radius);
      return push(r === null ? { kind: "line", to } : { kind: "radius", to, radius: machine.length(r), turn });
    }
    case "C": case "CP":
      if (!reader.pole) return machine.say(programIssue("poleMissing", "error", {}), index);
      return push({ kind: "centre", to, centre: reader.pole, turn });
  }
}

/** The first block of a contour names both coordinates: a control knows no point before it. */
function incomplete(reader: Reader, index: number): void {
  if (!reader.isTroubled && reader.elements.length === 0)
    reader.machine.say(programIssue("contourStartIncomplete", "error", { axis: reader.x === null ? "X" : "Z" }), index);
  reader.isTroubled = true;
}

const asRadius = (reader: Reader, x: number) => (reader.radii ? radius(x) : toRadius(diameter(x)));

function here(reader: Reader): Pt | null {
  return reader.x === null || reader.z === null ? null : { z: axial(reader.z), r: asRadius(reader, reader.x) };
}

function stand(reader: Reader, p: Pt): void {
  reader.z = p.z;
  reader.x = reader.radii ? p.r : toDiameter(p.r);
}

function move(reader: Reader, w: AxisWord, index: number): void {
  const n = reader.machine.number(w.value, index);
  if (w.axis !== "X" && w.axis !== "Z") return;
  if (n === null) {
    reader.isTroubled = true;
    return;
  }
  const key = w.axis === "X" ? "x" : "z";
  const length = reader.machine.length(n);
  const before = reader[key];
  if (w.incremental && before === null) return reader.machine.say(programIssue("startUnknown", "error", {}), index);
  reader[key] = w.incremental ? (before ?? 0) + length : length;
}

function centre(reader: Reader, axes: readonly AxisWord[], index: number): Pt | null {
  const at = { ...reader };
  for (const w of axes) move(at, w, index);
  return here(at);
}
