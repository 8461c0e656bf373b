import type { BlockDefinition } from "../../../nc/blocks/define.ts";
import { klartext } from "../../../nc/blocks/klartext.ts";
import { blockNumbers, startLines, type Program } from "../../../nc/program.ts";
import type { Statement } from "../../../nc/statement.ts";
import { actsAtOnce } from "../../../program/blocks/unproved-blocks.ts";
import type { Outcome } from "../../calculation/outcome.ts";
import { kindOf } from "./block-kind.ts";
import type { BlockKind } from "../../../nc/blocks/names.ts";
import { isDefinedIn } from "../../document/shown-findings.ts";

/** Filters of the list of parts. */
export type PartFilter = NonNullable<BlockDefinition["part"]>;

/** What an executed cycle call did. */
export interface Done {
  readonly passes: number;
  readonly seconds: number;
  /** Residual material, mm² of the half plane. */
  readonly residue: number;
}

/** One entry of the list of parts. */
export interface Part {
  /** Index of its block. */
  readonly index: number;
  /** Block number, printed or counted. */
  readonly number: number;
  readonly kind: BlockKind;
  readonly filter: PartFilter;
  /** Text of the block without its number. */
  readonly text: string;
  /** Cycles: sum over their calls; null if none was executed. */
  readonly done: Done | null;
  /** Tool calls: number or name of the tool; null elsewhere. */
  readonly tool: string | null;
  /** A DEF-active cycle, which needs no call. */
  readonly acts: boolean;
}

/** A subprogram end and the further lines of an old cycle are not listed. */
const isPart = (s: Statement): boolean =>
  !(s.kind === "label" && s.label === 0) && !(s.kind === "cycleLine" && s.line > 0 && s.cycle !== 14);

const HEAD = /^\s*(?:\/\s*)?(?:\d+(?![\d.,])\s*)?/;
const LINE = /^[^\r\n]*/;

/** The first line of a block without number and continuation. */
export function firstLine(raw: string): string {
  const from = HEAD.exec(raw)?.[0].length ?? 0;
  const line = (LINE.exec(raw.slice(from))?.[0] ?? "").trimEnd();
  return (line.endsWith("~") ? line.slice(0, -1).trimEnd() : line).replace(/\s+/g, " ");
}

/**
 * Results of the calls of each definition in one text, by the line of the definition. `file`: name of a called program.
 * A call without a path has no result.
 */
export function doneByLine({ run, simulation }: Outcome, file: string | null): ReadonlyMap<number, Done> {
  const all = new Map<number, Done>();
  run.operations.forEach((operation, i) => {
    if (operation.plan.moves.length === 0 || !isDefinedIn(operation, file)) return;
    const before = all.get(operation.definedLine) ?? { passes: 0, seconds: 0, residue: 0 };
    const residue = simulation.proof.residual.reduce((sum, r) => (r.operation === i ? sum + r.area : sum), 0);
    all.set(operation.definedLine, {
      passes: before.passes + operation.plan.passes,
      seconds: before.seconds + operation.seconds,
      residue: before.residue + residue,
    });
  });
  return all;
}

/** The parts of a program in their order: tools, cycles, labels, contours, notes. */
export function partsOf(program: Program, outcome: Outcome | null, file: string | null = null): readonly Part[] {
  const numbers = blockNumbers(program);
  const lines = outcome ? startLines(program) : [];
  const done = outcome ? doneByLine(outcome, file) : null;
  const parts: Part[] = [];
  program.blocks.forEach(({ statement: s, raw }, index) => {
    const filter = klartext.blockOf(s).part;
    if (filter === undefined || !isPart(s)) return;
    parts.push({
      index,
      number: numbers[index] ?? 0,
      kind: kindOf(s),
      filter,
      text: firstLine(raw),
      done: s.kind === "cycle" ? (done?.get(lines[index] ?? 0) ?? null) : null,
      tool: s.kind === "toolCall" && s.tool !== null && typeof s.tool !== "object" ? String(s.tool) : null,
      acts: s.kind === "cycle" && actsAtOnce(s.cycle),
    });
  });
  return parts;
}
