import { cycleByNumber } from "../../cycles/index.ts";
import { klartext } from "../../nc/blocks/klartext.ts";
import { perObject } from "../../nc/per-object.ts";
import type { Block, Program } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import type { Label, Parameter } from "../../nc/words.ts";
import { CONTOUR_CYCLE } from "../../nc/blocks/cycle-line.ts";
import { wordsOf } from "../blocks/flow.ts";
import { actsAtOnce, isSilent } from "../blocks/unproved-blocks.ts";

/** Blocks from `from`, `to` excluded. */
export interface BlockRange {
  readonly from: number;
  readonly to: number;
}

/** Why an operation cannot move: a called label, or shifted or rotated coordinates. */
export type FixedReason = "label" | "frame" | "tool";

/** One operation: a cycle with its calls, or cuts without one, and the tool. */
export interface OperationPart extends BlockRange {
  /** Its section in `Operations.sections`. */
  readonly section: number;
  /** Words of its structure comment; null where it has none of its own. */
  readonly title: string | null;
  /** Blocks that define its cycles; several where they are inseparable. */
  readonly definitions: readonly number[];
  /** Block of the tool call in force; null where none is. */
  readonly toolCall: number | null;
  /** An earlier operation calls the tool. */
  readonly inherits: boolean;
  /** Why it cannot be moved, duplicated, skipped or deleted. */
  readonly fixedReason: FixedReason | null;
}

/** Operations with one tool: common opening, each operation, and the common retraction. */
export interface ToolSection extends BlockRange {
  readonly opening: BlockRange;
  readonly closing: BlockRange;
  /** Indices in `Operations.units`. */
  readonly units: readonly number[];
}

/** A program split into operations. Outside are frame, blank, end and subprograms. */
export interface Operations extends BlockRange {
  readonly sections: readonly ToolSection[];
  readonly units: readonly OperationPart[];
}

const ENDS: readonly number[] = [2, 30];
const CALLS: readonly number[] = [89, 99];
const FEED_UNITS: readonly number[] = [136, 137];

/** Modal M functions of spindle and coolant: those that switch each on and off. A tool change ends both. */
export const KEPT_ON: readonly { readonly on: readonly number[]; readonly off: readonly number[] }[] = [
  {
    on: [3, 4, 13, 14, 303, 304],
    off: [5, 305],
  },
  { on: [7, 8, 13, 14], off: [9] },
];

const functionsOf = (s: Statement): readonly number[] => wordsOf(s)?.functions ?? [];
export const endsMain = (s: Statement): boolean => s.kind === "end" || functionsOf(s).some((m) => ENDS.includes(m));

/** True for a call of the defined cycle, or of something in its place. */
export const callsCycle = (s: Statement): boolean =>
  klartext.has(s, "calls") || functionsOf(s).some((m) => CALLS.includes(m));

/** A cycle that waits for its call. */
export const definesCycle = (s: Statement): boolean =>
  (s.kind === "cycle" && !actsAtOnce(s.cycle)) || (s.kind === "cycleLine" && s.line === 0 && !actsAtOnce(s.cycle));

const callsTool = (s: Statement): boolean => s.kind === "toolCall" && s.tool !== null;

const changesFrame = (s: Statement): boolean => {
  if (s.kind === "cycle" || s.kind === "cycleLine")
    return s.cycle !== CONTOUR_CYCLE && actsAtOnce(s.cycle) && (s.cycle === PRESET || !isSilent(s.cycle));
  return klartext.has(s, "movesFrame");
};
const PRESET = 247;

export const setsFeedUnit = (s: Statement): boolean =>
  s.kind === "functions" && functionsOf(s).every((m) => FEED_UNITS.includes(m));
const isRapid = (s: Statement): boolean =>
  (s.kind === "path" && s.words.feed === "max" && !callsCycle(s)) ||
  (s.kind === "functions" && s.words.retract !== undefined);
/** A block that only names the contour of the next cycle. */
export const namesContour = (s: Statement): boolean =>
  klartext.has(s, "namesContour") || (s.kind === "cycleLine" && s.cycle === CONTOUR_CYCLE);
const switchesOn = (s: Statement): boolean =>
  s.kind === "functions" && s.words.functions.every((m) => KEPT_ON.some(({ on }) => on.includes(m)));
const preparesCycle = (s: Statement): boolean =>
  klartext.has(s, "preparesCycle") ||
  namesContour(s) ||
  switchesOn(s) ||
  setsFeedUnit(s) ||
  (s.kind === "toolCall" && s.tool === null) ||
  changesFrame(s);
/** M functions that call no cycle. */
const onlySwitches = (s: Statement): boolean => s.kind === "functions" && !callsCycle(s);
/** Blocks allowed between a tool call and the first cut. */
const preparesTool = (s: Statement): boolean => klartext.has(s, "preparesTool") || isRapid(s) || onlySwitches(s);
/** Blocks allowed before the tool call of a section. */
const leadsTool = (s: Statement): boolean => klartext.has(s, "leadsTool") || setsFeedUnit(s);
const leaves = (s: Statement): boolean => klartext.has(s, "leaves") || isRapid(s) || onlySwitches(s);

/** Goes back from `at` over blocks of one kind, at most to `least`; returns the first index. */
function backOver(blocks: readonly Block[], at: number, least: number, is: (s: Statement) => boolean): number {
  let from = at;
  while (from > least && is(blocks[from - 1]?.statement ?? { kind: "end", name: "", unit: "MM" })) from -= 1;
  return from;
}

/** End of the main program: at M30 or M2, else at the first label behind all calls, else at END PGM. */
function endOfMain(blocks: readonly Block[]): number {
  const found = blocks.findIndex(({ statement: s, skip }) => endsMain(s) && !skip);
  if (found >= 0 && blocks[found]?.statement.kind !== "end") return found;
  const end = found < 0 ? blocks.length : found;
  const last = blocks.findLastIndex(({ statement: s }, i) => i < end && (callsCycle(s) || callsTool(s)));
  const label = blocks.findIndex(({ statement: s }, i) => i > last && i < end && s.kind === "label");
  return label < 0 ? end : label;
}

const titleIn = (blocks: readonly Block[], { from, to }: BlockRange): string | null => {
  const found = blocks.slice(from, to).find(({ statement: s }) => s.kind === "structure")?.statement;
  return found?.kind === "structure" && found.text.trim() !== "" ? found.text.trim() : null;
};

type Cuts = { readonly opening: BlockRange; readonly closing: BlockRange; readonly parts: readonly BlockRange[] };

/** Independent parts of a section, with their common opening and closing. */
function partsOf(blocks: readonly Block[], { from, to }: BlockRange): Cuts {
  const at = (i: number): Statement => blocks[i]?.statement ?? { kind: "empty" };
  const definitions: number[] = [];
  for (let i = from; i < to; i += 1) if (definesCycle(at(i))) definitions.push(i);
  let ready = from;
  while (ready < to && preparesTool(at(ready))) ready += 1;
  const lastCall = blocks.slice(from, to).findLastIndex(({ statement: s }) => !leaves(s)) + from;
  const closing = { from: Math.max(lastCall + 1, ready), to };
  const callFrom = (definition: number) => {
    for (let i = definition + 1; i < to && !definesCycle(at(i)); i += 1) if (callsCycle(at(i))) return i;
    return -1;
  };
  const begins = definitions.map((definition, k) => {
    const before = definitions[k - 1];
    const least = before === undefined ? from : Math.max(before + 1, lastCallIn(at, before, definition) + 1);
    const call = callFrom(definition);
    const until = call < 0 ? Math.min(definitions[k + 1] ?? to, closing.from) : call + 1;
    const comes = blocks.slice(definition, until).some(({ statement: s }) => s.kind === "path");
    const prelude = backOver(blocks, definition, least, preparesCycle);
    return comes ? prelude : backOver(blocks, prelude, least, (s) => preparesCycle(s) || isRapid(s));
  });
  const tool = blocks.slice(from, to).findIndex(({ statement: s }) => callsTool(s)) + from;
  // Structure items before the tool call belong to the tool; one after it begins the cut.
  const least = Math.max(tool + 1, from);
  const note = blocks.slice(least, ready).findIndex(({ statement: s }) => s.kind === "structure") + least;
  const first = Math.min(Math.max(begins[0] ?? ready, firstOwn(blocks, least)), note >= least ? note : Infinity);
  const starts = [Math.max(first, callsTool(at(tool)) ? least : from), ...begins.slice(1)];
  const clean =
    starts.every((start, k) => start <= (definitions[k] ?? closing.from)) && closing.from >= (starts.at(-1) ?? from);
  const opens = { from, to: starts[0] ?? from };
  const isClean =
    clean && definitions.length > 0 && blocks.slice(opens.from, opens.to).every(({ statement: s }) => preparesTool(s));
  if (!isClean) return { opening: { from, to: from }, closing: { from: to, to }, parts: [{ from, to }] };
  const parts = starts.map((start, k) => ({ from: start, to: starts[k + 1] ?? closing.from }));
  return { opening: opens, closing, parts };
}

/** First index behind the tool call, spindle and feed unit: a cut cannot begin earlier. */
function firstOwn(blocks: readonly Block[], from: number): number {
  let own = from;
  for (let i = from; i < blocks.length; i += 1) {
    const s = blocks[i]?.statement;
    if (!s || !(klartext.has(s, "ofTool") || setsFeedUnit(s) || s.kind === "comment")) break;
    if (s.kind !== "comment") own = i + 1;
  }
  return own;
}

function lastCallIn(at: (i: number) => Statement, from: number, to: number): number {
  for (let i = to - 1; i > from; i -= 1) if (callsCycle(at(i)) || (at(i).kind === "path" && !isRapid(at(i)))) return i;
  return from;
}

/** Ranges of the main program between a label and its calls or jumps: their operations are fixed. */
function tiedStretches(blocks: readonly Block[], end: number): readonly BlockRange[] {
  const labels = new Map<Label, number>();
  blocks.forEach(({ statement: s }, i) => {
    if (i < end && s.kind === "label" && s.label !== 0 && !labels.has(s.label)) labels.set(s.label, i);
  });
  const tied: BlockRange[] = [...labels.values()].map((i) => ({ from: i, to: i + 1 }));
  const ofUnknown = (label: Label | Parameter) => typeof label === "object" && labels.size > 0;
  blocks.forEach(({ statement: s }, i) => {
    if (i >= end || (s.kind !== "call" && s.kind !== "jump")) return;
    const target = typeof s.label === "object" ? undefined : labels.get(s.label);
    if (s.kind === "jump" || ofUnknown(s.label)) tied.push({ from: i, to: i + 1 });
    if (target !== undefined) tied.push({ from: Math.min(i, target), to: Math.max(i, target) + 1 });
  });
  return tied;
}

/** Whether a range has a block in common with any of these, of a program of `count` blocks. */
function touches(ranges: readonly BlockRange[], count: number): (range: BlockRange) => boolean {
  const open = new Int32Array(count + 1);
  for (const { from, to } of ranges) {
    open[from] = (open[from] ?? 0) + 1;
    open[to] = (open[to] ?? 0) - 1;
  }
  const covered = new Int32Array(count + 1);
  let depth = 0;
  for (let i = 0; i < count; i += 1) {
    depth += open[i] ?? 0;
    covered[i + 1] = (covered[i] ?? 0) + (depth > 0 ? 1 : 0);
  }
  return ({ from, to }) => (covered[to] ?? 0) > (covered[from] ?? 0);
}

function tieFor({
  hasLabel,
  framed,
  toolless,
}: {
  readonly hasLabel: boolean;
  readonly framed: boolean;
  readonly toolless: boolean;
}) {
  if (hasLabel) return "label";
  if (framed) return "frame";
  return toolless ? "tool" : null;
}

/** Splits a program into operations, one per cycle: from the tool call or structure item to the retraction. */
export const operationsOf = perObject(({ blocks }: Program): Operations => {
  const end = endOfMain(blocks);
  const tools: number[] = [];
  const at = (i: number): Statement => blocks[i]?.statement ?? { kind: "empty" };
  for (let i = 0; i < end; i += 1) if (callsTool(at(i))) tools.push(i);
  const firstCut = blocks.findIndex(({ statement: s }, i) => i < end && (definesCycle(s) || callsCycle(s)));
  const begins = Math.min(tools[0] ?? end, firstCut < 0 ? end : firstCut);
  const frame = blocks.slice(0, begins).findLastIndex(({ statement: s }) => klartext.has(s, "opening")) + 1;
  const toolStarts = tools.map((tool, k) =>
    backOver(blocks, tool, k === 0 ? frame : (tools[k - 1] ?? 0) + 1, leadsTool),
  );
  const [firstTool = Infinity] = toolStarts;
  const headless = firstCut >= 0 && firstCut < firstTool;
  const starts = [...(headless ? [frame] : []), ...toolStarts];
  const isTied = touches(tiedStretches(blocks, end), blocks.length);
  const units: OperationPart[] = [];
  // Parts follow each other, so the last tool call before the end of one is at or behind that of the one before.
  let called = -1;
  const sections = starts.map((from, section): ToolSection => {
    const whole = { from, to: starts[section + 1] ?? end };
    const hasLabel = isTied(whole);
    const cuts = hasLabel
      ? { opening: { from, to: from }, closing: { from: whole.to, to: whole.to }, parts: [whole] }
      : partsOf(blocks, whole);
    const own = cuts.parts.map((part, k): OperationPart => {
      const inside = blocks.slice(part.from, part.to);
      while ((tools[called + 1] ?? Infinity) < part.to) called += 1;
      const toolCall = tools[called] ?? -1;
      const framed = blocks
        .slice(k === 0 ? from : part.from, k === cuts.parts.length - 1 ? whole.to : part.to)
        .some(({ statement: s }) => changesFrame(s));
      const title = (k === 0 ? titleIn(blocks, cuts.opening) : null) ?? titleIn(blocks, part);
      return {
        ...part,
        section,
        title,
        definitions: inside.flatMap(({ statement: s }, i) => (definesCycle(s) ? [part.from + i] : [])),
        toolCall: toolCall < 0 ? null : toolCall,
        inherits: k > 0 || toolCall < from,
        fixedReason: tieFor({ hasLabel, framed, toolless: toolCall < 0 }),
      };
    });
    const first = units.length;
    for (const unit of own) units.push(unit);
    return { ...whole, opening: cuts.opening, closing: cuts.closing, units: own.map((_, k) => first + k) };
  });
  return { from: starts[0] ?? end, to: end, sections, units };
});

/** All blocks of an operation, including opening and closing blocks that it shares with no other. */
export function wholeOf({ sections, units }: Operations, unit: number): BlockRange {
  const own = units[unit];
  const section = own && sections[own.section];
  if (!own || !section) return { from: 0, to: 0 };
  const isFirst = section.units[0] === unit;
  const isLast = section.units.at(-1) === unit;
  return { from: isFirst ? section.from : own.from, to: isLast ? section.to : own.to };
}

/** Index of the operation that has a block, or of the last one before it; null without one. */
export function operationAt(program: Program, index: number): number | null {
  const found = operationsOf(program).units.findLastIndex(({ from }) => from <= index);
  return found < 0 ? null : found;
}

/** True for an operation whose cycles and calls all have a skip mark. */
export function isOff({ blocks }: Program, { from, to }: BlockRange): boolean {
  const acting = blocks.slice(from, to).filter(({ statement: s }) => definesCycle(s) || callsCycle(s));
  const all =
    acting.length > 0
      ? acting
      : blocks.slice(from, to).filter(({ statement: s }) => s.kind === "path" || s.kind === "approach");
  return all.length > 0 && all.every(({ skip }) => skip);
}

/** True where a cycle takes its contour from a subprogram. */
export const isOfFreeContour = (s: Statement): boolean =>
  s.kind === "cycle" && cycleByNumber(s.cycle)?.contour === "free";
export const isNote = (s: Statement): boolean => klartext.has(s, "note");
