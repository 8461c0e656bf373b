import type { Segment } from "../../kernel/geometry/point.ts";
import { part, type Pt } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { pathOf } from "../../kernel/time/time.ts";
import type { BlockSpan } from "./block-span.ts";
import { fileKey } from "../state/program-files.ts";
import type { Operation, Run, TextLine } from "../state/run-types.ts";
import { shiftedSegment } from "../blocks/shifted-plan.ts";

/** Consecutive moves by step index, first and last included. */
export interface MoveSpan {
  readonly first: number;
  readonly last: number;
}

/** A selection in a text or in the picture of a run. */
export type PathChoice =
  /** Blocks of the main program, and the first line of the chosen block. */
  | { readonly kind: "blocks"; readonly span: BlockSpan; readonly line: number }
  /** A block of a called file, by its first line. */
  | { readonly kind: "inFile"; readonly file: string; readonly line: number }
  /** Moves of one pass or phase of a cycle call; all of the call where neither is named. */
  | {
      readonly kind: "pass";
      readonly operation: number;
      readonly of?: Step["move"]["run"];
      readonly pass?: number | undefined;
    }
  /** Segments of the programmed contour, counted from 0. */
  | { readonly kind: "segments"; readonly segments: readonly number[] };

/** Marks of a choice in the picture. */
export interface Marked {
  readonly stretches: readonly MoveSpan[];
  readonly contour: readonly Segment[];
  /** Step at whose start the tool is shown; null where no step of the run belongs to the choice or follows it. */
  readonly begin: number | null;
}

const NOTHING: Marked = { stretches: [], contour: [], begin: null };

interface ContourPlace {
  readonly operation: number;
  readonly segment: number;
}

/** Blocks and lines of a run with their steps: built once, then only looked up. */
interface PathIndex {
  /** Blocks with steps, in text order, and the stretches of each. */
  readonly blocks: readonly number[];
  readonly ofBlock: ReadonlyMap<number, readonly MoveSpan[]>;
  readonly definedAt: ReadonlyMap<string, readonly number[]>;
  readonly contourAt: ReadonlyMap<string, readonly ContourPlace[]>;
}

const keyOf = (file: string | undefined, line: number) => `${line} ${file === undefined ? "" : fileKey(file)}`;

function noted<K, V>(map: Map<K, V[]>, key: K, value: V): void {
  const list = map.get(key);
  if (list) list.push(value);
  else map.set(key, [value]);
}

/** Consecutive steps with the same key form one stretch. */
export function stretchesBy<S, K>(steps: readonly S[], keyAt: (step: S, i: number) => K | null): Map<K, MoveSpan[]> {
  const all = new Map<K, MoveSpan[]>();
  let first = 0;
  let next = steps.length > 0 ? keyAt(steps[0] as S, 0) : null;
  for (let i = 0; i < steps.length; i += 1) {
    const key = next,
      isLast = i + 1 === steps.length;
    next = isLast ? null : keyAt(steps[i + 1] as S, i + 1);
    if (next === key && !isLast) continue;
    if (key !== null) noted(all, key, { first, last: i });
    first = i + 1;
  }
  return all;
}

function indexOf({ steps, stepBlocks, operations }: Run): PathIndex {
  const ofBlock = stretchesBy(steps, (_, i) => stepBlocks[i] ?? null);
  const definedAt = new Map<string, number[]>();
  const contourAt = new Map<string, ContourPlace[]>();
  operations.forEach(({ definedFile, definedLine, contourLines }, operation) => {
    noted(definedAt, keyOf(definedFile, definedLine), operation);
    contourLines?.forEach(({ file, line }, segment) => noted(contourAt, keyOf(file, line), { operation, segment }));
  });
  return {
    blocks: [...ofBlock.keys()].sort((a, b) => a - b),
    ofBlock,
    definedAt,
    contourAt,
  };
}

const indices = new WeakMap<Run, PathIndex>();

function pathIndex(run: Run): PathIndex {
  const known = indices.get(run) ?? indexOf(run);
  indices.set(run, known);
  return known;
}

/** First index of a sorted list that reaches a value. */
export function placeInSorted(sorted: readonly number[], value: number): number {
  let [low, high] = [0, sorted.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((sorted[middle] ?? 0) < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

const stretchOf = (run: Run, operation: number): readonly MoveSpan[] => {
  const { firstStep: first = 0, lastStep: last = -1 } = run.operations[operation] ?? {};
  return last < first ? [] : [{ first, last }];
};

const marking = (stretches: readonly MoveSpan[], contour: readonly Segment[] = []): Marked => ({
  stretches,
  contour,
  begin: stretches[0]?.first ?? null,
});

const middleOf = ({ from, move }: Step): Pt => part.pointOn(pathOf(from, move), 0.5);

/** Contour segments of a call in programmed order, where the picture has them. */
export function contourOf(operation: Operation): readonly Segment[] {
  const { call } = operation;
  return call?.given.contour?.map((segment) => shiftedSegment(segment, call.datum)) ?? [];
}

/** Moves that machine some contour segments: the nearest finishing moves, or the last pass of a roughing call. */
function movesAlong(run: Run, operation: number, chosen: ReadonlySet<number>): readonly MoveSpan[] {
  const [whole] = stretchOf(run, operation);
  const call = run.operations[operation];
  if (!whole || !call) return [];
  const contour = contourOf(call);
  const steps = run.steps.slice(whole.first, whole.last + 1);
  const finishes = steps.some(({ move }) => move.phase === "finish");
  const makes = ({ move }: Step) =>
    move.kind !== "rapid" &&
    (finishes ? move.phase === "finish" : move.pass === call.plan.passes && move.phase !== "position");
  const nearest = (p: Pt) => {
    const far = contour.map((s) => part.distanceTo(s, p));
    return far.indexOf(Math.min(...far));
  };
  const along =
    stretchesBy(steps, (step) => (makes(step) && chosen.has(nearest(middleOf(step))) ? true : null)).get(true) ?? [];
  return along.map(({ first, last }) => ({ first: first + whole.first, last: last + whole.first }));
}

/** Marks of contour segments: their drawing, and the moves that machine them. */
function alongContour(run: Run, places: readonly ContourPlace[]): Marked {
  const [first] = places;
  if (!first) return NOTHING;
  const mine = places.filter(({ operation }) => operation === first.operation).map(({ segment }) => segment);
  const call = run.operations[first.operation];
  const contour = call ? contourOf(call).filter((_, i) => mine.includes(i)) : [];
  const of = [...new Set(places.map(({ operation }) => operation))];
  return marking(
    of.flatMap((operation) =>
      movesAlong(
        run,
        operation,
        new Set(places.filter((p) => p.operation === operation).map(({ segment }) => segment)),
      ),
    ),
    contour,
  );
}

const inOrder = (stretches: readonly MoveSpan[]) => stretches.toSorted((a, b) => a.first - b.first);

function ofBlocks(run: Run, { span: { from, to }, line }: Extract<PathChoice, { kind: "blocks" }>): Marked {
  const { blocks, ofBlock, definedAt, contourAt } = pathIndex(run);
  const own: MoveSpan[] = [];
  for (let i = placeInSorted(blocks, from); i < blocks.length && (blocks[i] ?? to + 1) <= to; i += 1)
    for (const span of ofBlock.get(blocks[i] ?? -1) ?? []) own.push(span);
  if (own.length > 0) return marking(inOrder(own));
  const defined = definedAt.get(keyOf(undefined, line))?.flatMap((operation) => stretchOf(run, operation)) ?? [];
  if (defined.length > 0) return marking(defined);
  const contour = contourAt.get(keyOf(undefined, line));
  if (contour) return alongContour(run, contour);
  const next = blocks[placeInSorted(blocks, to)];
  return { ...NOTHING, begin: next === undefined ? null : (ofBlock.get(next)?.[0]?.first ?? null) };
}

function ofFileBlock(run: Run, { file, line }: Extract<PathChoice, { kind: "inFile" }>): Marked {
  const { definedAt, contourAt } = pathIndex(run),
    key = keyOf(file, line);
  const own = stretchesBy(run.steps, (step) =>
    step.line !== undefined && keyOf(step.file, step.line) === key ? true : null,
  ).get(true);
  if (own) return marking(own);
  const defined = definedAt.get(key);
  if (defined) return marking(defined.flatMap((operation) => stretchOf(run, operation)));
  const contour = contourAt.get(key);
  return contour ? alongContour(run, contour) : NOTHING;
}

function ofPass(run: Run, { operation, of, pass }: Extract<PathChoice, { kind: "pass" }>): Marked {
  const [whole] = stretchOf(run, operation);
  if (!whole || of === undefined) return marking(whole ? [whole] : []);
  const steps = run.steps.slice(whole.first, whole.last + 1);
  const mine = ({ move }: Step) =>
    move.run === of && (pass === undefined || move.pass === pass) && move.phase !== "position";
  const found = stretchesBy(steps, (step) => (mine(step) ? true : null)).get(true) ?? [];
  return marking(found.map(({ first, last }) => ({ first: first + whole.first, last: last + whole.first })));
}

/** Marks of a choice in a run. The cost depends on the marks, not on the length of the run. */
export function markedBy(run: Run, choice: PathChoice): Marked {
  switch (choice.kind) {
    case "blocks":
      return ofBlocks(run, choice);
    case "inFile":
      return ofFileBlock(run, choice);
    case "pass":
      return ofPass(run, choice);
    case "segments":
      return alongContour(
        run,
        run.operations.flatMap((o, operation) =>
          o.contourLines
            ? choice.segments.map((segment) => ({
                operation,
                segment,
              }))
            : [],
        ),
      );
  }
}

/** Choice of a move in the picture: its pass, or outside the cycles its block. */
export function choiceOf(run: Run, step: number): PathChoice | null {
  const made = run.steps[step];
  if (!made) return null;
  const { operation, move } = made;
  if (operation !== null) return { kind: "pass", operation, of: move.run, pass: move.pass };
  if (made.file !== undefined && made.line !== undefined) return { kind: "inFile", file: made.file, line: made.line };
  const block = run.stepBlocks[step];
  return block === undefined ? null : { kind: "blocks", span: { from: block, to: block }, line: 0 };
}

/** Part of the path to show around the current step: cycle call, phase, or pass. */
export type RunningPart = "operation" | "phase" | "pass";

/** Path part of a step; between two cycles that of the next one. */
export function runningPart(run: Run, step: number, part: RunningPart): PathChoice | null {
  const { operation, move } = run.steps[Math.min(step, run.steps.length - 1)] ?? {};
  const next =
    operation ?? run.operations.findIndex(({ firstStep, lastStep }) => firstStep > step && lastStep >= firstStep);
  const shown = next < 0 ? run.operations.length - 1 : next;
  if (shown < 0) return null;
  if (part === "operation" || move === undefined || operation === null) return { kind: "pass", operation: shown };
  return { kind: "pass", operation: shown, of: move.run, ...(part === "pass" && { pass: move.pass }) };
}

/** Dialog of a move: the definition of its cycle, or its own block outside the cycles of a called file. */
export function definitionOf(run: Run, step: number): TextLine | null {
  const { operation = null, file, line } = run.steps[step] ?? {};
  const made = operation === null ? undefined : run.operations[operation];
  if (made) return { line: made.definedLine, ...(made.definedFile !== undefined && { file: made.definedFile }) };
  return file !== undefined && line !== undefined ? { file, line } : null;
}
