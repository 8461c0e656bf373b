import { segmentTo, type PathElement } from "../../kernel/contour/contour.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import type { Pt, Segment } from "../../kernel/geometry/point.ts";
import { axial, diameter, inDegrees, radians, radius, toDiameter, toRadius } from "../../kernel/units.ts";
import type { AxisName, AxisWord, PathKind, PolarWord, Value, Words } from "../../nc/words.ts";
import type { ControlRule } from "./issue.ts";
import { toProgram, toWorkpiece, type CoordinateFrame } from "../tools/coordinates-frame.ts";

/** A position in program terms, mm; null while unknown. X is a diameter while turning. */
export interface Position {
  readonly x: number | null;
  readonly y: number | null;
  readonly z: number | null;
}
export const NOWHERE: Position = { x: null, y: null, z: null };

/**
 * A plane that a path runs in. Its angles count from the first axis towards the second: X to Y, Y to Z, Z to X. "lathe"
 * is the plane of a turning tool, Z to X with diameters in X; an outline in radii lies in "ZX".
 */
export type Plane = "XY" | "YZ" | "ZX" | "lathe";
const AXES_OF = { XY: ["x", "y"], YZ: ["y", "z"], ZX: ["z", "x"], lathe: ["z", "x"] } as const;

/** A plane of a mill. */
export type MillPlane = Exclude<Plane, "lathe">;

/** CC: its coordinates, omitted ones from the tool position, and the milling plane that it names. */
export interface Pole {
  readonly at: Position;
  readonly plane: MillPlane;
}

/** Plane of the axes in a milling block: that of the tool axis unless it names Z with another axis. */
export function planeOfAxes(words: readonly AxisWord[]): MillPlane {
  const has = (axis: AxisName) => words.some((w) => w.axis === axis);
  if (!has("Z") || has("X") === has("Y")) return "XY";
  return has("X") ? "ZX" : "YZ";
}

/** A position as a point of a plane; null when a coordinate is unknown. */
export function pointIn(plane: Plane, p: Position): Pt | null {
  const [a, b] = AXES_OF[plane];
  const [first, second] = [p[a], p[b]];
  if (first === null || second === null) return null;
  return { z: axial(first), r: plane === "lathe" ? toRadius(diameter(second)) : radius(second) };
}

/** The two coordinates that a point of a plane has. */
export function coordinatesIn(plane: Plane, to: Pt): Partial<Record<keyof Position, number>> {
  const [a, b] = AXES_OF[plane];
  return { [a]: to.z, [b]: plane === "lathe" ? toDiameter(to.r) : to.r };
}

/** Faults of a path: its start, its pole, its arc. */
export type PathFault = "startUnknown" | "poleMissing" | "arcImpossible";

/** Converts words of a block into numbers and reports faults. */
export interface WordReader {
  /** Null where the number is unknown, which is reported already. */
  readonly number: (value: Value) => number | null;
  /** A length of the program in mm. */
  readonly length: (n: number) => number;
  /**
   * Offset of the datum of absolute coordinates from that of the positions; "unknown" where unknown, null where no path
   * runs along the axis.
   */
  readonly shift: (axis: AxisName) => number | "unknown" | null;
  /** Frame of mirrored, rotated or scaled coordinates; null where they are at most shifted. */
  readonly frame: CoordinateFrame | null;
  /** A word names an axis that no path runs along. */
  readonly otherAxis: (word: AxisWord, n: number) => void;
  /** A coordinate has no number, for a reported reason. */
  readonly onUnknown: () => void;
  readonly fault: (code: PathFault) => void;
  /** Reports words that break a printed rule of the control. */
  readonly rule: (rule: ControlRule, word: string) => void;
}

/** Reads typed words; `unit` in mm. Faults are reported elsewhere. A missing number is NaN. */
export const plainReader = (unit: number): WordReader => ({
  number: (value) => (typeof value === "number" && !Number.isNaN(value) ? value : null),
  length: (n) => n * unit,
  shift: () => 0,
  frame: null,
  otherAxis: () => undefined,
  onUnknown: () => undefined,
  fault: () => undefined,
  rule: () => undefined,
});

/** A block that moves on a path. */
export interface PathBlock {
  readonly path: Exclude<PathKind, "CC" | "RND">;
  readonly words: Words;
}

/** Reference position and pole of the words of a block. */
export interface Standing {
  readonly plane: Plane;
  readonly at: Position;
  readonly pole: Pt | null;
}

const POLAR: ReadonlySet<PathKind> = new Set(["LP", "CP", "CTP"]);
export const isPolarPath = (path: PathKind): boolean => POLAR.has(path);

/** Axis words on top of the position before them. */
export function coordinates(read: WordReader, words: readonly AxisWord[], at: Position): Position {
  if (!read.frame || words.length === 0) return counted(read, words, at, read.shift);
  const along = (axis: AxisName) => (read.shift(axis) === null ? null : 0);
  return placed(
    read.frame,
    counted(read, words, toProgram(read.frame, at), along),
    at,
    words.map((w) => w.axis),
  );
}

/** Position in the workpiece; an axis without a word keeps its exact previous value. */
function placed(frame: CoordinateFrame, to: Position, before: Position, axes: readonly AxisName[]): Position {
  const made = toWorkpiece(frame, to);
  const mixed = frame.transform.rotation !== 0 && (axes.includes("X") || axes.includes("Y"));
  return {
    x: mixed || axes.includes("X") ? made.x : before.x,
    y: mixed || axes.includes("Y") ? made.y : before.y,
    z: axes.includes("Z") ? made.z : before.z,
  };
}

/** Applies axis words to a position in the same or in shifted coordinates. */
function counted(read: WordReader, words: readonly AxisWord[], at: Position, shiftOf: WordReader["shift"]): Position {
  const to = { ...at };
  for (const w of words) {
    const n = read.number(w.value);
    const shift = shiftOf(w.axis);
    if (shift === null) {
      if (n !== null) read.otherAxis(w, n);
      continue;
    }
    const key = w.axis.toLowerCase() as keyof Position;
    const before = to[key];
    if (n === null || (shift === "unknown" && !w.incremental)) {
      to[key] = null;
      read.onUnknown();
    } else if (!w.incremental && shift !== "unknown") to[key] = read.length(n) + shift;
    else if (before !== null) to[key] = before + read.length(n);
    else read.fault("startUnknown");
  }
  return to;
}

/**
 * Point of PR and PA about a pole: PR is a true length, PA counts from the first axis to the second. An omitted word
 * keeps the previous distance or angle. Null where a number is unknown.
 */
export function polarPoint(
  read: WordReader,
  { polarRadius, polarAngle }: Words,
  pole: Pt,
  before: Pt | null,
): Pt | null {
  const [dz, dr] = before ? [before.z - pole.z, before.r - pole.r] : [0, 0];
  const value = (word: PolarWord | undefined, was: number, measured: (n: number) => number) => {
    if (!word) return was;
    const n = read.number(word.value);
    return n === null ? null : measured(n) + (word.incremental ? was : 0);
  };
  const distance = value(polarRadius, Math.hypot(dz, dr), read.length);
  const angle = value(polarAngle, inDegrees(Math.atan2(dr, dz)), (n) => n);
  if (distance === null || angle === null) return null;
  const a = radians(angle);
  return { z: axial(pole.z + distance * Math.cos(a)), r: radius(pole.r + distance * Math.sin(a)) };
}

/** Whether polar words count from the point before. */
const leans = ({ polarRadius, polarAngle }: Words) => [polarRadius, polarAngle].some((w) => !w || w.incremental);

const pick = (p: Position, a: keyof Position, b: keyof Position) => ({ [a]: p[a], [b]: p[b] });

/** End of a block, by its axes or about the pole; null where its pole is missing, which is reported already. */
export function endOf(read: WordReader, { path, words }: PathBlock, { plane, at, pole }: Standing): Position | null {
  const to = coordinates(read, words.linear ? [...words.axes, ...words.linear] : words.axes, at);
  if (!isPolarPath(path)) return to;
  if (!pole) {
    read.fault("poleMissing");
    return null;
  }
  const { frame } = read;
  const before = pointIn(plane, frame ? toProgram(frame, at) : at);
  const centre = frame ? pointIn(plane, toProgram(frame, { ...NOWHERE, ...coordinatesIn(plane, pole) })) : pole;
  const [a, b] = AXES_OF[plane];
  const nowhere = { ...to, [a]: null, [b]: null };
  if (!before && leans(words)) {
    read.fault("startUnknown");
    return nowhere;
  }
  const end = centre && polarPoint(read, words, centre, before);
  const made = end && coordinatesIn(plane, end);
  if (made) return { ...to, ...(frame ? pick(toWorkpiece(frame, { ...NOWHERE, ...made }), a, b) : made) };
  read.onUnknown();
  return nowhere;
}

/** The arcs of a path. */
const ARCS: ReadonlySet<PathKind> = new Set(["C", "CR", "CT", "CP", "CTP"]);
export const isArcPath = (path: PathKind): boolean => ARCS.has(path);

/** An incremental angle must have the sign of DR. */
function signs(read: WordReader, { polarAngle, turn }: Words): void {
  const n = polarAngle?.incremental && turn ? read.number(polarAngle.value) : null;
  if (n !== null && n !== 0 && n > 0 !== (turn === "ccw"))
    read.rule("signOfAngle", `IPA${n > 0 ? "+" : ""}${n} DR${turn === "ccw" ? "+" : "-"}`);
}

/** Element of a block with a given end point; null where its pole or radius is missing, which is reported already. */
export function elementOf(read: WordReader, { path, words }: PathBlock, to: Pt, pole: Pt | null): PathElement | null {
  const turn = words.turn ?? "ccw";
  switch (path) {
    case "L":
    case "LP":
      return { kind: "line", to };
    case "CT":
    case "CTP":
      return { kind: "tangent", to };
    case "CR": {
      const r = words.radius === undefined ? null : read.number(words.radius);
      return r === null ? null : { kind: "radius", to, radius: read.length(r), turn };
    }
    case "C":
    case "CP":
      signs(read, words);
      if (!pole) read.fault("poleMissing");
      return pole && { kind: "centre", to, centre: pole, turn };
  }
}

/** Start, end, pole and previous segment of a block. */
export interface Course {
  readonly from: Pt;
  readonly to: Pt;
  readonly pole: Pt | null;
  readonly before: Segment | null;
}

/** Segment of a block: a line where its arc is impossible, which is reported already. */
export function segmentOf(read: WordReader, block: PathBlock, { from, to, pole, before }: Course): Segment {
  const element = elementOf(read, block, to, pole) ?? { kind: "line", to };
  const faults: Issue[] = [];
  const segment = segmentTo(from, before ?? undefined, element, 1, faults);
  if (faults.length > 0) read.fault("arcImpossible");
  return segment;
}
