import { SAME } from "../../kernel/tolerance.ts";
import { contourFrom, type Contour, type ContourElement } from "../../kernel/contour/contour.ts";
import { at as pointAt, part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import type { Statement, StatementOf } from "../../nc/statement.ts";
import type { Label, PathKind, Words } from "../../nc/words.ts";
import { assign, assignText } from "./assign.ts";
import { isFreeElement, solveFree, type FreeBlock } from "../state/free-contour.ts";
import { collectFree, sayChosen, sayUnsolved } from "./free-words.ts";
import { breaksRule, isWholePoint } from "../state/control-rule.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";
import type { ContourSource } from "../state/modal.ts";
import {
  coordinates,
  elementOf,
  endOf,
  isArcPath,
  NOWHERE,
  pointIn,
  segmentOf,
  type PathBlock,
  type Position,
  type WordReader,
} from "../state/path.ts";
import { wordOf, wordReader } from "../motion/path-block.ts";
import { recessOf } from "./recess-words.ts";
import { nameOf } from "./unproved-blocks.ts";

/** A contour with the block each of its elements came from. */
export interface Subprogram {
  readonly contour: Contour;
  /** Index of the block of each element, in order. */
  readonly blocks: readonly number[];
  /** A block could not be read; it is reported already. */
  readonly isTroubled: boolean;
}

interface Reader {
  readonly machine: Machine;
  /** "ZX" for an outline in radii. */
  readonly plane: "lathe" | "ZX";
  readonly elements: ContourElement[];
  readonly blocks: number[];
  at: Position;
  pole: Pt | null;
  /** Whether the last point named both coordinates; null where this is not checked. */
  isWhole: boolean | null;
  /** Previous element, for a tangential free contour. */
  last: Segment | null;
  /** Elements of free contours, by their blocks. */
  solved: ReadonlyMap<number, FreeBlock | null>;
  /** A coordinate had no number. */
  isTroubled: boolean;
}

/** Longest contour that is read. The run ends beyond it: a truncated contour would be another part. */
const MOST_BLOCKS = 20_000;

/**
 * Reads the contour behind a label of the running program; null when the label does not exist. `radii`: X words are
 * radii (DIM_R).
 */
export const readContour = (machine: Machine, label: Label, at: number, radii = false): Subprogram | null =>
  readContourOf(machine, { unit: machine.unit, label }, at, radii);

/** Reads a contour up to the LBL 0 of its label, or to the end of its file. */
export function readContourOf(
  machine: Machine,
  { unit, label }: ContourSource,
  at: number,
  radii = false,
): Subprogram | null {
  const start = label === null ? unit.from - 1 : unit.labels.get(label);
  if (start === undefined) {
    machine.log.report(programIssue("labelMissing", "error", { label: String(label) }), at);
    return null;
  }
  const outer = machine.parameters;
  machine.known.hideLocals();
  const { inch } = machine.now;
  machine.set({ inch: unit.inch });
  const reader: Reader = {
    machine,
    plane: radii ? "ZX" : "lathe",
    elements: [],
    blocks: [],
    at: NOWHERE,
    pole: null,
    isWhole: null,
    last: null,
    solved: new Map(),
    isTroubled: false,
  };
  let i = start + 1;
  for (; i < unit.to; i += 1) {
    machine.visit(i);
    if (machine.isSkipped(i)) continue;
    const statement = machine.blocks[i]?.statement;
    if (!statement || (statement.kind === "label" && statement.label === 0) || statement.kind === "end") break;
    if (i - start > MOST_BLOCKS) machine.stop(programIssue("contourTooLong", "error", { limit: MOST_BLOCKS }), at);
    if (!machine.roomForBlock(at)) break;
    element(reader, statement, i);
  }
  const end = i < unit.to ? machine.blocks[i]?.statement : undefined;
  if (label !== null && end?.kind !== "label" && !machine.run.full)
    machine.log.report(programIssue("labelNotClosed", "warning", { label: String(label) }), start);
  machine.set({ inch });
  machine.known.parameters = outer;
  if (machine.run.full) return null;
  const { memory } = machine.shop;
  const make = () => contourFrom(reader.elements);
  return {
    contour: memory ? memory.cached(`contour ${memory.serialized(reader.elements)}`, make) : make(),
    blocks: reader.blocks,
    isTroubled: reader.isTroubled,
  };
}

/** Text of a block, without its number. */
const lineOfBlock = (machine: Machine, index: number) =>
  (machine.blocks[index]?.raw ?? "").trim().replace(/^\/?\d*[ \t]*\/?[ \t]*/, "");

function element(reader: Reader, s: Statement, index: number): void {
  switch (s.kind) {
    case "path":
      return path(reader, s, index);
    case "free":
      return free(reader, s, index);
    case "chamfer":
      first(reader, "CHF", s.words, index);
      return corner(reader, "chamfer", s.length === null ? null : reader.machine.number(s.length, index), index);
    case "assign":
      return assign(reader.machine, s, index);
    case "assignText":
      return assignText(reader.machine, s, index);
    case "undercut":
    case "groove": {
      const recess = recessOf(reader.machine, s, index);
      return recess ? push(reader, recess, index) : undefined;
    }
    case "approach":
    case "call":
    case "callProgram":
    case "callSelected":
    case "cycleCall":
    case "jump":
    case "datum":
    case "datumTable":
    case "mirror":
    case "rotation":
    case "scale":
    case "plane":
    case "unknown":
      return reader.machine.log.leaveUnproved(nameOf(lineOfBlock(reader.machine, index)), index);
    default:
      return;
  }
}

function push(reader: Reader, e: ContourElement, index: number): void {
  reader.elements.push(e);
  reader.blocks.push(index);
}

/** Size 0 keeps the count of elements right where the size is missing. */
const corner = (reader: Reader, kind: "chamfer" | "round", size: number | null, index: number): void =>
  push(reader, { kind, size: reader.machine.length(size ?? 0) }, index);

/**
 * Coordinates of a contour count from its own datum. Faults of words are reported here, not again as faults of the
 * contour; a missing previous point is reported where the first point is incomplete.
 */
const wordsOf = (reader: Reader, index: number): WordReader => ({
  ...wordReader(reader.machine, index),
  shift: (axis) => (axis === "X" || axis === "Z" ? 0 : null),
  frame: null,
  onUnknown: () => void (reader.isTroubled = true),
  fault: (code) => {
    if (code === "startUnknown") return;
    if (!reader.isTroubled) reader.machine.log.report(programIssue(code, "error", {}), index);
    reader.isTroubled = true;
  },
  rule: (rule, word) => {
    breaksRule(reader.machine, rule, word, index);
    reader.isTroubled = true;
  },
});

function path(reader: Reader, { path: kind, words }: Extract<Statement, { kind: "path" }>, index: number): void {
  const { machine, plane, at, pole } = reader;
  const read = wordsOf(reader, index);
  if (kind !== "CC") first(reader, kind, words, index);
  if (kind === "RND")
    return corner(reader, "round", words.radius === undefined ? null : machine.number(words.radius, index), index);
  if (kind === "CC") {
    if (words.axes.length === 0 && reader.isWhole === false) read.rule("emptyCentre", "CC");
    reader.pole = pointIn(plane, coordinates(read, words.axes, at));
    return;
  }
  const block: PathBlock = { path: kind, words };
  reader.isWhole = isWholePoint(kind, words, true) ?? reader.isWhole;
  reader.at = endOf(read, block, { plane, at, pole }) ?? at;
  const to = pointIn(plane, reader.at);
  const from = pointIn(plane, at);
  reader.last =
    from && to && segmentOf({ ...read, fault: () => undefined }, block, { from, to, pole, before: reader.last });
  const before = from && to && part.apart(from, to) <= SAME ? reader.elements.at(-1) : undefined;
  if (before?.kind === "round" || before?.kind === "chamfer") read.rule("zeroBehindCorner", wordOf(before));
  if (to) push(reader, elementOf(read, block, to, pole) ?? { kind: "line", to }, index);
  else incomplete(reader, index);
}

const scaled = (s: Segment, unit: number): Segment => {
  const smaller = (p: Pt) => pointAt(p.z / unit, p.r / unit);
  const [from, to] = [smaller(s.from), smaller(s.to)];
  return s.kind === "line" ? { kind: "line", from, to } : { ...s, from, to, centre: smaller(s.centre) };
};

/** An element of a free contour, solved together with the elements that follow. */
function free(reader: Reader, s: StatementOf<"free">, index: number): void {
  if (!isFreeElement(s)) return;
  const { machine, plane, at } = reader;
  if (reader.elements.length === 0 && !reader.isTroubled && s.form !== "FL") notFirst(reader, s.form, index);
  reader.isWhole = null;
  if (!reader.solved.has(index)) {
    const { run, indices } = collectFree(machine, index);
    const from = pointIn(plane, at);
    const unit = machine.length(1);
    const blocks = solveFree(run, {
      plane: plane === "lathe" ? "lathe" : "radii",
      from: from && { x: from.z / unit, y: from.r / unit },
      before: reader.last && scaled(reader.last, unit),
      number: (value) => machine.number(value, index),
    });
    reader.solved = new Map(indices.map((i, k) => [i, blocks[k] ?? null]));
  }
  const made = reader.solved.get(index);
  if (made) {
    if (made.isChosen) sayChosen(machine, index);
    return path(reader, made.path, index);
  }
  reader.isTroubled = true;
  sayUnsolved(machine, s, index);
}

/** The first block of a contour must not count from a previous point. */
function first(reader: Reader, kind: PathKind | "CHF", { axes, polarRadius, polarAngle }: Words, index: number): void {
  if (reader.elements.length > 0 || reader.isTroubled) return;
  const word = axes.find((w) => w.incremental);
  if (kind === "CHF" || kind === "RND" || isArcPath(kind)) notFirst(reader, kind, index);
  else if (word) notFirst(reader, `I${word.axis}`, index);
  else if (polarRadius?.incremental || polarAngle?.incremental)
    notFirst(reader, polarAngle?.incremental ? "IPA" : "IPR", index);
}

function notFirst(reader: Reader, word: string, index: number): void {
  reader.machine.log.report(programIssue("firstElement", "error", { word }), index);
  reader.isTroubled = true;
}

/** The first block of a contour names both coordinates: a control has no previous point. */
function incomplete(reader: Reader, index: number): void {
  if (!reader.isTroubled && reader.elements.length === 0)
    reader.machine.log.report(
      programIssue("contourStartIncomplete", "error", { axis: reader.at.x === null ? "X" : "Z" }),
      index,
    );
  reader.isTroubled = true;
}
