import { planePoint } from "../../../kernel/plane/plane.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { planeThumbnailOf, type Thumbnail } from "../../../view/thumbnail.ts";
import { blockNumbers, startLines, type Program } from "../../../nc/program.ts";
import type { Severity } from "../../../kernel/plan/issue.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import { canBeFinished } from "../../../program/edits/finishing-operation.ts";
import { isOff, operationsOf, wholeOf, type FixedReason } from "../../../program/edits/operations.ts";
import type { Outcome } from "../../calculation/outcome.ts";
import { doneByLine, firstLine, type Done } from "./program-parts.ts";
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
  readonly blocks: readonly { readonly index: number; readonly number: number; readonly text: string }[];
}

/** The block that opens with an operation. */
export function openingBlock(program: Program, unit: number): number | null {
  const own = operationsOf(program).units[unit];
  return own ? (own.definitions[0] ?? own.from) : null;
}

/** Run time of a block range, s. */
function secondsIn({ run }: Outcome, from: number, to: number): number {
  const turned = run.steps.reduce((sum, step, i) => {
    const block = run.stepBlocks[i] ?? -1;
    return block >= from && block < to ? sum + step.seconds : sum;
  }, 0);
  return run.plane.reduce((sum, step) => (step.index >= from && step.index < to ? sum + step.seconds : sum), turned);
}

/** The path of a block range as a small picture: milled in X/Y, or turned in Z/X. */
export function pathPicture({ plane, cuboid, steps, stepBlocks }: Run, from: number, to: number): Thumbnail | null {
  const milled = planeThumbnailOf(
    plane.filter(({ index }) => index >= from && index < to),
    cuboid,
  );
  if (milled) return milled;
  const turned = steps.flatMap(({ from: start, move: { kind, to: end } }, i) => {
    const block = stepBlocks[i] ?? -1;
    if (block < from || block >= to) return [];
    // A line without width: in a section, the tool is no disc.
    return [{ kind, from: { ...planePoint(start), z: null }, to: { ...planePoint(end), z: null }, radius: 0 }];
  });
  return planeThumbnailOf(turned);
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

/** Whether the last mode set before a block is turning. */
function turnsBefore(program: Program, index: number): boolean {
  const mode = program.blocks.slice(0, index).findLast(({ statement }) => statement.kind === "mode")?.statement;
  return mode?.kind === "mode" && mode.mode === "TURN";
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
  const numbers = blockNumbers(program);
  const lines = startLines(program);
  const done = outcome ? doneByLine(outcome, file) : null;
  const places = entries.map((entry) => ({ at: indexOf(program, entry), severity: entry.issue.severity }));
  return all.units.map((own, unit): OperationRow => {
    const { from, to } = wholeOf(all, unit);
    const called = own.toolCall === null ? undefined : program.blocks[own.toolCall]?.statement;
    const tool =
      called?.kind === "toolCall" && called.tool !== null
        ? typeof called.tool === "object"
          ? called.tool.parameter
          : String(called.tool)
        : null;
    const here = places.filter(({ at }) => at >= from && at < to).map(({ severity }) => severity);
    const worst = (["error", "warning", "info"] as const).find((each) => here.includes(each));
    const did = added(own.definitions.map((index) => done?.get(lines[index] ?? 0)));
    const seconds = outcome && file === null ? secondsIn(outcome, from, to) : 0;
    const cycles = own.definitions.flatMap((index) => {
      const s = program.blocks[index]?.statement;
      return s?.kind === "cycle" || s?.kind === "cycleLine" ? [s.cycle] : [];
    });
    // Before the first run, the mode of the machine tells it.
    const isMilled =
      file === null &&
      (outcome
        ? outcome.run.plane.some(({ index }) => index >= from && index < to)
        : cycles.length === 0 && !turnsBefore(program, to));
    return {
      unit,
      title: own.title,
      cycles,
      path: outcome && file === null && cycles.length === 0 ? pathPicture(outcome.run, from, to) : null,
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
      done: did
        ? { ...did, seconds: Math.max(seconds, did.seconds) }
        : seconds > 0
          ? { passes: 0, seconds, residue: 0 }
          : null,
      findings: worst ? { count: here.length, severity: worst } : null,
      blocks: program.blocks
        .slice(from, to)
        .flatMap(({ raw, statement }, i) =>
          statement.kind === "empty" ? [] : [{ index: from + i, number: numbers[from + i] ?? 0, text: firstLine(raw) }],
        ),
    };
  });
}
