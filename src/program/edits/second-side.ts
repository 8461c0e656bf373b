import { areaOfRing } from "../../kernel/area/area.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { areaOfArc, elementsThrough, type Nearness } from "../../kernel/contour/elements-through.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { IN_MM, radius, toDiameter } from "../../kernel/units.ts";
import { parse } from "../../nc/parse.ts";
import { programText } from "../../nc/print.ts";
import type { Program } from "../../nc/program.ts";
import { styleAt } from "../../nc/read-style.ts";
import type { Statement, StatementOf } from "../../nc/statement.ts";
import { noWords, type AxisWord } from "../../nc/words.ts";
import { roundedTo } from "../values/field.ts";
import type { NcOutput } from "../machine/nc-output.ts";
import { setsFeedUnit } from "./operations.ts";
import { outputIn } from "./output-in.ts";
import { SAFE_DISTANCE, nameOnControl } from "../job/print-job.ts";
import { POSITION_DECIMALS } from "../values/typed-value.ts";

/** Options of the second clamping. */
export interface SecondSideOptions {
  /** Facing allowance at the new front, mm: Z0 is this far behind it. */
  readonly allowance: number;
  /** NC output where the first program does not show it. */
  readonly output: NcOutput;
  /** False where the operations that follow call their own tools: the program calls none. Absent: it does. */
  readonly callsTool?: boolean;
}

/** Label of the outline of the blank. */
const BLANK_LABEL = 1;
/**
 * Decimals of the outline: as many as a control accepts. Its resolution would move a long cylinder by more than the
 * chords of an arc.
 */
const OUTLINE_DECIMALS = { MM: 4, INCH: 5 } as const;
/** Longer arcs are split, radians: near half a turn the end points barely define the centre. */
const WIDEST = (2 / 3) * Math.PI;
/** A shorter arc is a corner, mm. */
const SHORTEST_ARC = 0.01;
/** Tolerance of the outline, mm: the stock has each arc, of tool and path, as chords. */
const NEAR: Nearness = { line: SAME, arc: 5 * CHORD };
/** Area error allowed for a radius with fewer decimals, mm². */
const AREA_TOLERANCE = 0.001;
/** Longest name of a program on the control. */
const LONGEST_NAME = 32;

/** The name of the next clamping: PART becomes PART_2, and PART_2 becomes PART_3. */
export function nextClampingName(name: string): string {
  const [, stem = name, count] = /^(.+)_(\d)$/.exec(name) ?? [];
  const end = `_${count === undefined ? 2 : Number(count) + 1}`;
  return nameOnControl(stem).slice(0, LONGEST_NAME - end.length) + end;
}

/**
 * A piece turned end for end: its rear face becomes the front, `front` mm before Z0. Applying it twice restores the
 * piece.
 */
export function flippedPiece(piece: readonly Ring[], front: number): Ring[] {
  const { left } = boxAround([...piece]);
  return piece.map((ring) => ring.map((p) => at(left - p.z + front, p.r)).reverse());
}

/** Elements of a ring, from its frontmost point nearest to the axis, where a setter begins an outline. */
function elementsOf(ring: Ring): readonly Segment[] {
  const first = ring.reduce((best, p, i) => {
    const now = ring[best] ?? p;
    return p.z > now.z || (p.z === now.z && p.r < now.r) ? i : best;
  }, 0);
  return elementsThrough([...ring.slice(first), ...ring.slice(0, first + 1)], NEAR);
}

function asWritten(s: Segment): Segment[] {
  if (s.kind === "line") return [s];
  if (part.lengthOf(s) < SHORTEST_ARC) return [part.line(s.from, s.to)];
  const count = Math.ceil(part.sweepOf(s) / WIDEST),
    point = (i: number) => part.pointOn(s, i / count);
  return Array.from({ length: count }, (_, i) => ({
    ...s,
    from: i === 0 ? s.from : point(i),
    to: i + 1 === count ? s.to : point(i + 1),
  }));
}

/**
 * One closed outline of a piece. A cavity is connected by a line run both ways, which encloses nothing: a blank has one
 * outline.
 */
function outlineOf(piece: readonly Ring[]): readonly Segment[] {
  const chains = piece.toSorted((a, b) => areaOfRing(b) - areaOfRing(a)).map(elementsOf);
  const [outer = [], ...cavities] = chains,
    begin = outer[0]?.from;
  if (!begin) return [];
  return [
    ...outer,
    ...cavities.flatMap((cavity) => {
      const to = cavity[0]?.from;
      return to ? [part.line(begin, to), ...cavity, part.line(to, begin)] : [];
    }),
  ].flatMap(asWritten);
}

/** Radius of an arc with the fewest decimals within the area tolerance. `per`: mm per program unit. */
function radiusWritten(arc: Extract<Segment, { kind: "arc" }>, per: number, decimals: number): number {
  const chord = part.apart(arc.from, arc.to),
    exact = part.radiusOf(arc),
    area = areaOfArc(chord, exact);
  const most = Math.min(AREA_TOLERANCE, CHORD * part.lengthOf(arc));
  for (let digits = 0; digits < decimals; digits += 1) {
    const fewer = roundedTo(exact / per, digits);
    if (2 * fewer * per > chord && Math.abs(areaOfArc(chord, fewer * per) - area) <= most) return fewer;
  }
  return roundedTo(exact / per, decimals);
}

/** Blocks of an outline: unchanged axes are left out, and so are elements without length after rounding. */
function outlineStatements(segments: readonly Segment[], unit: "MM" | "INCH"): Statement[] {
  const decimals = OUTLINE_DECIMALS[unit],
    per = IN_MM[unit === "INCH" ? "inch" : "mm"];
  const written = (p: Pt) => ({ X: roundedTo(toDiameter(p.r) / per, decimals), Z: roundedTo(p.z / per, decimals) });
  const [first] = segments;
  if (!first) return [];
  let before: { readonly X: number; readonly Z: number } | null = null;
  const statement = (to: Pt, arc: Extract<Segment, { kind: "arc" }> | null): Statement[] => {
    const now = written(to),
      was = before;
    const axes = (["X", "Z"] as const).flatMap((axis): AxisWord[] =>
      arc !== null || was?.[axis] !== now[axis] ? [{ axis, value: now[axis], incremental: false }] : [],
    );
    if (was?.X === now.X && was.Z === now.Z) return [];
    before = now;
    const words = { ...noWords, axes };
    if (!arc) return [{ kind: "path", path: "L", words }];
    return [
      { kind: "path", path: "CR", words: { ...words, radius: radiusWritten(arc, per, decimals), turn: arc.turn } },
    ];
  };
  return [...statement(first.from, null), ...segments.flatMap((s) => statement(s.to, s.kind === "arc" ? s : null))];
}

/**
 * The blocks of a blank of any shape: the one that states it, and its outline at the end of the program. `piece`: outline
 * and cavities, mm; null where there is none.
 */
function blankBlocks(
  piece: readonly Ring[],
  unit: "MM" | "INCH",
): { readonly opening: Statement; readonly behind: readonly Statement[] } | null {
  const outline = outlineStatements(outlineOf(piece), unit);
  if (outline.length === 0) return null;
  return {
    opening: { kind: "blankRotation", axis: "Z", measure: "D", outline: { label: BLANK_LABEL }, inner: null },
    behind: [{ kind: "label", label: BLANK_LABEL }, ...outline, { kind: "label", label: 0 }],
  };
}

/** A program that states no blank, in mm, with one of any shape. `piece`: outline and cavities, mm. */
export function withShapedBlank(program: Program, piece: readonly Ring[]): Program {
  const [begin, ...others] = program.blocks.map(({ statement }) => statement);
  const end = others.pop();
  const blank = blankBlocks(piece, "MM");
  if (!begin || !end || !blank) return program;
  return parse(programText([begin, blank.opening, ...others, ...blank.behind, end], styleAt(program, 0)));
}

/** Whether a statement means the same in another program: it has no Q parameters. */
const isPlain = (s: Statement): boolean => !JSON.stringify(s).includes('"parameter"');

/**
 * Turning settings of the first program before it cuts: mode with kinematics, the first turning tool (mostly the facing
 * tool of the second side too), speed, feed unit. A call with a tool axis is one of a mill.
 */
function turningOf({ blocks }: Program): Statement[] {
  const all = blocks.map(({ statement }) => statement).filter(isPlain);
  const mode = all.find((s) => s.kind === "mode" && s.mode === "TURN") ?? {
    kind: "mode",
    mode: "TURN",
    kinematics: null,
  };
  const call = all.find(
    (s): s is StatementOf<"toolCall"> => s.kind === "toolCall" && s.tool !== null && s.axis === null,
  );
  if (!call) return [mode];
  const tool: Statement = { ...call, speed: null, feed: null, deltaLength: null, deltaRadius: null, extra: [] };
  return [mode, tool, ...[all.find((s) => s.kind === "spin"), all.find(setsFeedUnit)].filter((s) => s !== undefined)];
}

/**
 * Program of the next clamping: the remaining piece, turned end for end, is its blank; Z0 at the new front or behind
 * the facing allowance. It is complete but for operations. `piece`: outline and cavities in the first clamping, mm;
 * returns an empty text where there is none.
 */
export function secondSide(
  program: Program,
  piece: readonly Ring[],
  { allowance, output: otherwise, callsTool = true }: SecondSideOptions,
): string {
  const begin = program.blocks.find(({ statement: s }) => s.kind === "begin")?.statement;
  const [name, unit] =
    begin?.kind === "begin" ? [nextClampingName(begin.name), begin.unit] : [nextClampingName("PROGRAM"), "MM" as const];
  const turned = flippedPiece(piece, allowance);
  const blank = blankBlocks(turned, unit);
  if (!blank) return "";
  const output = outputIn(program, otherwise),
    per = IN_MM[unit === "INCH" ? "inch" : "mm"];
  const { high } = boxAround(turned);
  const away = (axis: "X" | "Z", mm: number): AxisWord => ({
    axis,
    value: roundedTo(Math.ceil(mm) / per, POSITION_DECIMALS),
    incremental: false,
  });
  const clear: Statement = {
    kind: "path",
    path: "L",
    words: {
      ...noWords,
      axes: [
        away("X", toDiameter(radius(high)) + SAFE_DISTANCE.x),
        away("Z", Math.max(allowance, 0) + SAFE_DISTANCE.z),
      ],
      compensation: "R0",
      feed: "max",
    },
  };
  const all: Statement[] = [
    { kind: "begin", name, unit },
    blank.opening,
    ...turningOf(program).filter(({ kind }) => callsTool || kind === "mode"),
    ...(callsTool ? [clear] : []),
    { kind: "functions", words: { ...noWords, functions: [output.end] } },
    ...blank.behind,
    { kind: "end", name, unit },
  ];
  const isNumbered = program.blocks.some(({ number }) => number !== null);
  return programText(all, styleAt(program, 0), isNumbered);
}
