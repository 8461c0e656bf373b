import { cycleByNumber } from "../../cycles/index.ts";
import { isUnsimulated } from "../../cycles/unsimulated-cycles.ts";
import type { FeedUnit } from "../../kernel/plan/move.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import type { Spindle, Step } from "../../kernel/time/step.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { IN_MM, type LengthUnit } from "../../kernel/units.ts";
import { blockNumbers, startLines, type Program } from "../../nc/program.ts";
import type { AxisName } from "../../nc/words.ts";
import { wordsOf } from "../../program/blocks/flow.ts";
import { isOff, KEPT_ON, operationsOf, wholeOf } from "../../program/edits/operations.ts";
import type { Mill } from "../../program/tools/plane-types.ts";
import type { Operation, Run } from "../../program/state/run-types.ts";
import { definedIn, calledName, toolCallsOf, isNamed, isParameter, speedOf } from "./tool-calls.ts";

/** A feed of an operation as the program states it. */
export interface SheetFeed {
  readonly value: number;
  /** A lead: the feed is locked to the spindle. */
  readonly unit: FeedUnit | "lead";
}

/** One operation of the sheet. */
export interface SheetOperation {
  /** Words of its structure comment; null where it has none. */
  readonly title: string | null;
  readonly cycles: readonly number[];
  /** Number of its first block; null where it stands in a called program or a subprogram. */
  readonly block: number | null;
  /** Index in `SetupData.tools`; null without a tool. */
  readonly tool: number | null;
  /** Tool position at its first cycle call; null before a run. */
  readonly start: Pt | null;
  readonly spindle: Spindle | null;
  readonly feeds: readonly SheetFeed[];
  readonly passes: number;
  readonly seconds: number;
  /** Switched off by skip marks. */
  readonly isOff: boolean;
}

/** One tool of the sheet, in the order in which it is first called. */
export interface SheetTool {
  /** Its number or name as the program calls it. */
  readonly called: string;
  /** The row of the turning tool table, or the drill. */
  readonly tool: Tool | null;
  /** The row of the milling tool table. */
  readonly mill: Mill | null;
  /** Its TOOL DEF data, in the unit of the program; null without TOOL DEF. */
  readonly defined: { readonly length: number | null; readonly radius: number | null } | null;
  /** M functions for spindle and coolant while the tool is in use. */
  readonly spindle: readonly number[];
  readonly coolant: readonly number[];
}

/** The data that a setter needs for a program. */
export interface SetupData {
  readonly name: string;
  readonly unit: LengthUnit;
  readonly blocks: number;
  readonly operations: readonly SheetOperation[];
  readonly tools: readonly SheetTool[];
  /** Size of a box-shaped milling blank along X, Y and Z, mm; null without one. */
  readonly box: readonly [x: number, y: number, z: number] | null;
  /** Calls of another tool, the first one included. */
  readonly toolChanges: number;
  readonly seconds: number;
  /** Activated presets, as written. */
  readonly presets: readonly string[];
  /** Datum shifts from the workpiece zero, each once. */
  readonly shifts: readonly Pt[];
  /** Referenced files: programs, contours, blanks. */
  readonly files: readonly string[];
  /** Unknown cycles, not simulated. */
  readonly unknownCycles: readonly number[];
}

/** Inputs of the setup data; `run` is null before the first calculation. */
export interface SetupInput {
  readonly program: Program;
  readonly run: Run | null;
  readonly tools: readonly Tool[];
  readonly mills: readonly Mill[];
}

const PRESET = 247;
const PRESET_NUMBER = "Q339";
const [SPINDLE, COOLANT] = KEPT_ON.map(({ on }) => on);

/** Datums nearer than this are equal, mm. */
const ONE = 0.0005;

/** Feeds of the cuts of steps, each once, in the order in which they are first used. */
function feedsOf(steps: readonly Step[]): readonly SheetFeed[] {
  const out: SheetFeed[] = [];
  const add = (value: number, unit: SheetFeed["unit"]) => {
    if (!out.some((each) => each.value === value && each.unit === unit)) out.push({ value, unit });
  };
  for (const { move } of steps) {
    if (move.kind === "thread") add(move.pitch, "lead");
    else if (move.kind !== "rapid" && move.phase !== "position") add(move.feed, move.feedUnit);
  }
  return out;
}

const sum = (all: readonly { readonly seconds: number }[]): number =>
  all.reduce((total, { seconds }) => total + seconds, 0);

const functionsIn = ({ blocks }: Program, from: number, to: number): readonly number[] =>
  blocks.slice(from, to).flatMap(({ statement }) => wordsOf(statement)?.functions ?? []);
const once = <T>(values: readonly T[]): readonly T[] => [...new Set(values)];

function fileNames({ blocks }: Program): readonly string[] {
  return once(
    blocks.flatMap(({ statement: s }) => {
      if (!("file" in s)) return [];
      return typeof s.file === "string" && s.file.trim() !== "" ? [s.file.trim()] : [];
    }),
  );
}

/** The box between the two corners of BLK FORM 0.1 and 0.2, where both are numbers. */
function boxOf({ blocks }: Program, unit: LengthUnit): SetupData["box"] {
  const corners = blocks.flatMap(({ statement: s }) => (s.kind === "blankBox" ? [s] : []));
  const [first, second] = [corners.find(({ corner }) => corner === 1), corners.find(({ corner }) => corner === 2)];
  const along = (axis: AxisName): number => {
    const [a, b] = [first, second].map((corner) => corner?.axes.find((word) => word.axis === axis));
    if (typeof a?.value !== "number" || typeof b?.value !== "number") return 0;
    return Math.abs(b.incremental ? b.value : b.value - a.value) * IN_MM[unit];
  };
  const [x, y, z] = [along("X"), along("Y"), along("Z")];
  return x > 0 && y > 0 && z > 0 ? [x, y, z] : null;
}

function presetsOf({ blocks }: Program): readonly string[] {
  return once(
    blocks.flatMap(({ statement: s }) => {
      if (s.kind !== "cycle" || s.cycle !== PRESET) return [];
      const value = s.parameters.find(({ q }) => q === PRESET_NUMBER)?.value;
      return value === undefined || value === null ? [] : [typeof value === "object" ? value.parameter : String(value)];
    }),
  );
}

function shiftsOf(run: Run | null): readonly Pt[] {
  const out: Pt[] = [];
  for (const { at } of run?.datums ?? []) {
    const known = [...out, { z: 0, r: 0 }].some(
      (each) => Math.abs(each.z - at.z) < ONE && Math.abs(each.r - at.r) < ONE,
    );
    if (!known) out.push(at);
  }
  return out;
}

interface Placed {
  readonly order: number;
  readonly operation: SheetOperation;
}

/** The setup data of a program, from its text and its run. */
export function setupData({ program, run, tools, mills }: SetupInput): SetupData {
  const all = operationsOf(program);
  const numbers = blockNumbers(program),
    lines = startLines(program);
  const calls = toolCallsOf(program, run, all.to);
  const list: SheetTool[] = [];
  const indexOf = new Map<string, number>();
  calls.forEach(({ index, called, ran, turns }, i) => {
    const tool = turns ? (tools.find(isNamed(ran ? String(ran.T) : called)) ?? ran) : null;
    const mill = mills.find(isNamed(called)) ?? null;
    const key = `${tool ? "turn" : "mill"} ${tool?.T ?? mill?.T ?? called}`;
    const used = functionsIn(program, index, Math.max(calls[i + 1]?.index ?? all.to, index));
    const [spindle, coolant] = [SPINDLE, COOLANT].map((on = []) => once(used.filter((m) => on.includes(m))));
    const known = indexOf.get(key),
      before = known === undefined ? undefined : list[known];
    const next: SheetTool = {
      called,
      tool,
      mill: tool ? null : mill,
      defined: definedIn(program, called),
      spindle: once([...(before?.spindle ?? []), ...(spindle ?? [])]),
      coolant: once([...(before?.coolant ?? []), ...(coolant ?? [])]),
    };
    if (known !== undefined) list[known] = next;
    else indexOf.set(key, list.push(next) - 1);
  });
  const toolIndex = (called: string | null, ran: Tool | null): number | null => {
    const isMeant = ({ called: own, tool, mill }: SheetTool) => {
      if (called === null || isParameter(called)) return ran !== null && tool?.T === ran.T;
      return own === called || (tool !== null && isNamed(called)(tool)) || (mill !== null && isNamed(called)(mill));
    };
    const found = list.findIndex(isMeant);
    return found < 0 ? null : found;
  };
  const stepsIn = (from: number, to: number) =>
    run?.steps.filter((_, i) => {
      const block = run.stepBlocks[i] ?? -1;
      return block >= from && block < to;
    }) ?? [];
  const taken = new Set<Operation>();
  const rows = all.units.map((own, unit): Placed => {
    const { from, to } = wholeOf(all, unit);
    const steps = stepsIn(from, to);
    const plane = run?.plane.filter(({ index }) => index >= from && index < to) ?? [];
    const [low, high] = [lines[from] ?? 0, lines[to] ?? Infinity];
    const ran =
      run?.operations.filter((o) => o.definedFile === undefined && o.definedLine >= low && o.definedLine < high) ?? [];
    for (const each of ran) taken.add(each);
    const called = own.toolCall === null ? undefined : program.blocks[own.toolCall]?.statement;
    const first = ran[0];
    const planeFeeds = plane.flatMap(({ feed, feedUnit }) =>
      feed === undefined ? [] : [{ value: feed, unit: feedUnit ?? "mm/min" }],
    );
    const cut = ran.length > 0 ? ran.flatMap((o) => run?.steps.slice(o.firstStep, o.lastStep + 1) ?? []) : steps;
    return {
      order: from,
      operation: {
        title: own.title,
        cycles: own.definitions.flatMap((index) => {
          const s = program.blocks[index]?.statement;
          return s?.kind === "cycle" || s?.kind === "cycleLine" ? [s.cycle] : [];
        }),
        block: numbers[from] ?? null,
        tool: toolIndex(called ? calledName(called) : null, first?.tool ?? steps[0]?.tool ?? null),
        start: first?.start ?? null,
        spindle: first?.spindle ?? speedOf(called),
        feeds: [
          ...feedsOf(cut),
          ...planeFeeds.filter((f, i) => planeFeeds.findIndex((g) => g.value === f.value && g.unit === f.unit) === i),
        ],
        passes: ran.reduce((total, { plan }) => total + plan.passes, 0),
        seconds: Math.max(sum(steps) + sum(plane), sum(ran)),
        isOff: isOff(program, own),
      },
    };
  });
  const apart = (run?.operations ?? [])
    .filter((o) => !taken.has(o))
    .map((o): Placed => ({
      order: Math.max(0, (run?.stepBlocks ?? []).slice(0, o.firstStep).findLast((block) => block < all.to) ?? 0) + 0.5,
      operation: {
        title: null,
        cycles: [o.cycle],
        block: null,
        tool: toolIndex(null, o.tool),
        start: o.start,
        spindle: o.spindle,
        feeds: feedsOf(run?.steps.slice(o.firstStep, o.lastStep + 1) ?? []),
        passes: o.plan.passes,
        seconds: o.seconds,
        isOff: false,
      },
    }));
  const cycles = program.blocks.flatMap(({ statement: s }) => (s.kind === "cycle" ? [s.cycle] : []));
  const begin = beginOf(program),
    unit = run?.program.unit ?? (begin?.unit === "INCH" ? "inch" : "mm");
  return {
    name: run?.program.name || begin?.name || "",
    unit,
    blocks: program.blocks.filter(({ statement: s }) => s.kind !== "empty").length,
    operations: [...rows, ...apart].sort((a, b) => a.order - b.order).map(({ operation }) => operation),
    tools: list,
    box: boxOf(program, unit),
    toolChanges: calls.filter(({ called }, i) => called !== calls[i - 1]?.called).length,
    seconds: run?.seconds ?? 0,
    presets: presetsOf(program),
    shifts: shiftsOf(run),
    files: fileNames(program),
    unknownCycles: once(cycles.filter((cycle) => !cycleByNumber(cycle) && !isUnsimulated(cycle) && !isPlain(cycle))),
  };
}

/** Cycles without machining: datums, coordinates, stops, contours. */
const isPlain = (cycle: number): boolean => cycle < 200 || cycle === PRESET;

/** The block that a program begins with. */
function beginOf({ blocks }: Program) {
  const begin = blocks.find(({ statement }) => statement.kind === "begin")?.statement;
  return begin?.kind === "begin" ? begin : null;
}
