import { withBlock } from "../../nc/edit.ts";
import type { Program } from "../../nc/program.ts";
import type { StatementOf } from "../../nc/statement.ts";
import type { CycleParameter } from "../../nc/words.ts";
import { operationsOf } from "../../program/edits/operations.ts";
import { roundedDownTo } from "../../kernel/units.ts";
import { noseRadius } from "../../kernel/cutter/insert.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { isRefused, retooledOperation, type Refusal } from "../../program/edits/operation-edits.ts";
import type { Replacement } from "./change.ts";
import { writtenNumber, type TurningUnit } from "./situation.ts";

type CycleStatement = StatementOf<"cycle">;

/** A cycle with other numbers for some of its parameters. */
export const withNumbers = (statement: CycleStatement, numbers: Readonly<Record<string, number>>): CycleStatement => ({
  ...statement,
  parameters: statement.parameters.map((p): CycleParameter => {
    const value = numbers[p.q];
    return value === undefined ? p : { ...p, value };
  }),
});

/** The cycle of an operation with other numbers. */
export const withValues = (
  { definition, statement }: TurningUnit,
  numbers: Readonly<Record<string, number>>,
): Replacement => ({
  index: definition,
  statement: withNumbers(statement, numbers),
});

/** The program with other numbers in the first cycle of an operation, which may be new. */
export function withNumbersIn(program: Program, unit: number, numbers: Readonly<Record<string, number>>): Program {
  const index = operationsOf(program).units[unit]?.definitions[0];
  const statement = index === undefined ? undefined : program.blocks[index]?.statement;
  return index !== undefined && statement?.kind === "cycle"
    ? withBlock(program, index, withNumbers(statement, numbers))
    : program;
}

/** The cutting speed of an operation that has a tool section of its own as a share; null without one to change. */
export function withSpeedShare(program: Program, unit: number, share: number): Program | null {
  const all = operationsOf(program);
  const section = all.sections.find(({ units }) => units.length === 1 && units[0] === unit);
  if (!section) return null;
  const index = program.blocks.findIndex(
    ({ statement }, i) => statement.kind === "spin" && i >= section.from && i < section.to,
  );
  const spin = program.blocks[index]?.statement;
  if (spin?.kind !== "spin" || !spin.constantSurface || typeof spin.cuttingSpeed !== "number") return null;
  return withBlock(program, index, { ...spin, cuttingSpeed: Math.round(spin.cuttingSpeed * share) });
}

/** Step of a feed, mm/rev. */
const FEED_STEP = 0.005;

/**
 * Another tool for an operation like `of`, with the roughness of the former one: Rz = f²/8r, so that a smaller nose
 * takes a smaller finishing feed.
 */
export function retooled(program: Program, unit: number, of: TurningUnit, tool: Tool): Program | Refusal {
  const made = retooledOperation(program, unit, tool.T);
  const written = writtenNumber(of, "finishingFeed");
  const share = Math.sqrt(noseRadius(tool) / noseRadius(of.operation.tool));
  if (isRefused(made) || !written || of.work === "rough" || !(share < 1)) return made;
  const feed = Math.max(FEED_STEP, roundedDownTo(FEED_STEP, written.value * share));
  return withNumbersIn(made, unit, { [written.q]: feed });
}
