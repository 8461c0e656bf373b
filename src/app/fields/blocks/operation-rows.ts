import { planePoint } from "../../../kernel/plane/plane.ts";
import type { Cuboid } from "../../../kernel/area/box.ts";
import type { Step } from "../../../kernel/time/step.ts";
import { placeInSorted } from "../../../program/run/path-index.ts";
import type { Run } from "../../../program/state/run-types.ts";
import type { PlaneStep } from "../../../program/tools/plane-types.ts";
import { planeThumbnailOf, type Thumbnail } from "../../../view/thumbnail.ts";
import { startLines, type Program } from "../../../nc/program.ts";
import type { Severity } from "../../../kernel/plan/issue.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import { canBeFinished } from "../../../program/edits/finishing-operation.ts";
import { isOff, operationsOf, wholeOf, type FixedReason } from "../../../program/edits/operations.ts";
import type { Outcome } from "../../calculation/outcome.ts";
import { doneByLine, type Done } from "./program-parts.ts";
import type { FindingEntry } from "../../findings/entry.ts";
import { indexOf } from "./repairs.ts";

/** One operation of the list. */
export interface OperationRow {
  /** Index among all operations, from 0. */
  readonly unit: number;
  /** Text of its structure item; null without one. */
  readonly title: string | null;
  /** Numbers of its cycles. */
  readonly cycles: readonly number[];
  /** Number or name of its tool as the program says it; null without one. */
  readonly tool: string | null;
  /** The row of the tool table. */
  readonly known: Tool | null;
  readonly inherits: boolean;
  /** Its path where it has no cycle: milled, or turned block by block. */
  readonly path: Thumbnail | null;
  readonly isOff: boolean;
  /** Its cycle roughs, so the same sizes can be finished with another tool. */
  readonly canBeFinished: boolean;
  readonly tie: FixedReason | null;
  /** Block range, including opening and closing blocks that belong to this operation alone. */
  readonly from: number;
  readonly to: number;
  /** Block that the row opens: its cycle, or its first block. */
  readonly opens: number;
  /** Result of its calls; null if none was run. */
  readonly done: Done | null;
  readonly findings: { readonly count: number; readonly severity: Severity } | null;
}

/** The block that opens with an operation. */
export function openingBlock(program: Program, unit: number): number | null {
  const own = operationsOf(program).units[unit];
  return own ? (own.definitions[0] ?? own.from) : null;
}

/** The motions of a run in its turning and in its milling plane, in the order of the blocks that say it. */
interface Motions {
  readonly turned: readonly Step[];
  readonly milled: readonly PlaneStep[];
}

/** Finds those of a list whose blocks lie in a range: sorted once, since a program has many ranges. */
function byBlock<T>(all: readonly T[], blockOf: (each: T, i: number) => number) {
  const placed = all.map((each, i) => ({ each, block: blockOf(each, i) })).sort((a, b) => a.block - b.block);
  const blocks = placed.map(({ block }) => block);
  return (from: number, to: number): readonly T[] =>
    placed.slice(placeInSorted(blocks, from), placeInSorted(blocks, to)).map(({ each }) => each);
}

/** Finds the motions of a run in a range of blocks. */
export function motionsOf({ steps, stepBlocks, plane }: Run): (from: number, to: number) => Motions {
  const turnedIn = byBlock(steps, (_, i) => stepBlocks[i] ?? -1);
  const milledIn = byBlock(plane, ({ index }) => index);
  return (from, to) => ({ turned: turnedIn(from, to), milled: milledIn(from, to) });
}

const secondsOf = ({ turned, milled }: Motions) =>
  [...turned, ...milled].reduce((sum, { seconds }) => sum + seconds, 0);

/** A path as a small picture: milled in X/Y, or turned in Z/X. */
export function pathPicture({ turned, milled }: Motions, cuboid: Cuboid | null): Thumbnail | null {
  // A line without width: in a section, the tool is no disc.
  const inSection = ({ from, move: { kind, to } }: Step) =>
    ({ kind, from: { ...planePoint(from), z: null }, to: { ...planePoint(to), z: null }, radius: 0 }) as const;
  return planeThumbnailOf(milled, cuboid) ?? planeThumbnailOf(turned.map(inSection));
}

function added(all: readonly (Done | undefined)[]): Done | null {
  const ran = all.filter((each) => each !== undefined);
  return ran.length === 0
    ? null
    : ran.reduce((sum, each) => ({
        passes: sum.passes + each.passes,
        seconds: sum.seconds + each.seconds,
        residue: sum.residue + each.residue,
      }));
}

/** The operations of a text for the list; `outcome` and `entries` belong to that text. */
export function operationRows(
  program: Program,
  {
    outcome,
    file,
    entries,
    tools,
  }: {
    readonly outcome: Outcome | null;
    readonly file: string | null;
    readonly entries: readonly FindingEntry[];
    readonly tools: readonly Tool[];
  },
): readonly OperationRow[] {
  const all = operationsOf(program);
  const lines = startLines(program);
  const done = outcome ? doneByLine(outcome, file) : null;
  const placesIn = byBlock(entries, (entry) => indexOf(program, entry));
  const motionsIn = outcome && file === null ? motionsOf(outcome.run) : null;
  let turns = false,
    read = 0;
  /** Whether the last mode set before a block is turning; asked in their order. */
  const turnsBefore = (index: number): boolean => {
    for (; read < index; read += 1) {
      const statement = program.blocks[read]?.statement;
      if (statement?.kind === "mode") turns = statement.mode === "TURN";
    }
    return turns;
  };
  return all.units.map((own, unit): OperationRow => {
    const { from, to } = wholeOf(all, unit);
    const called = own.toolCall === null ? undefined : program.blocks[own.toolCall]?.statement;
    const tool =
      called?.kind === "toolCall" && called.tool !== null
        ? typeof called.tool === "object"
          ? called.tool.parameter
          : String(called.tool)
        : null;
    const here = placesIn(from, to).map(({ issue }) => issue.severity);
    const worst = (["error", "warning", "info"] as const).find((each) => here.includes(each));
    const result = added(own.definitions.map((index) => done?.get(lines[index] ?? 0)));
    const motions = motionsIn?.(from, to);
    const seconds = motions ? secondsOf(motions) : 0;
    const cycles = own.definitions.flatMap((index) => {
      const s = program.blocks[index]?.statement;
      return s?.kind === "cycle" || s?.kind === "cycleLine" ? [s.cycle] : [];
    });
    // Before the first run, the mode of the machine tells it.
    const isMilled = file === null && (motions ? motions.milled.length > 0 : cycles.length === 0 && !turnsBefore(to));
    return {
      unit,
      title: own.title,
      cycles,
      path: outcome && motions && cycles.length === 0 ? pathPicture(motions, outcome.run.cuboid) : null,
      tool,
      // A milling cutter may have the number of a turning tool.
      known: isMilled ? null : (tools.find(({ T, NAME }) => String(T) === tool || NAME === tool) ?? null),
      inherits: own.inherits,
      isOff: isOff(program, own),
      canBeFinished: canBeFinished(program, own),
      tie: own.fixedReason,
      from,
      to,
      opens: own.definitions[0] ?? own.from,
      done: result
        ? { ...result, seconds: Math.max(seconds, result.seconds) }
        : seconds > 0
          ? { passes: 0, seconds, residue: 0 }
          : null,
      findings: worst ? { count: here.length, severity: worst } : null,
    };
  });
}
