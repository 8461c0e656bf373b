import type { Cycle } from "../../cycles/define.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import type { Param, Topic } from "../../cycles/params.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { startLines, type Program } from "../../nc/program.ts";
import type { StatementOf } from "../../nc/statement.ts";
import { isOff, operationsOf, type Operations } from "../../program/edits/operations.ts";
import type { NcLanguage } from "../../nc/nc-languages.ts";
import type { CutMaterial } from "../../program/tools/cutting-table.ts";
import type { Operation, Run } from "../../program/state/run-types.ts";
import type { Simulation } from "../../sim/simulation.ts";
import { usesOf, type Uses } from "./uses.ts";

/** The result of a program. */
export interface Attempt {
  readonly run: Run;
  readonly simulation: Simulation;
}

/** A program that is tried: its run, and its stock on demand, since most tries are decided by their run. */
export interface Trial {
  readonly run: Run;
  readonly simulated: () => Simulation;
}

/** What a search for better ways knows besides the result of the program. */
export interface Conditions {
  /** The valid tools of the table. */
  readonly tools: readonly Tool[];
  /** The material in use, and whether the work states it; power of the spindle, kW. */
  readonly material: CutMaterial;
  readonly isStated: boolean;
  readonly power: number;
  /** The language of labels in NC text. */
  readonly ncLanguage: NcLanguage;
}

/** The parts of a machining: both, roughing only, finishing only (to the contour or to the oversize). */
export type Work = "both" | "rough" | "finish";
export const WORKS: Readonly<Record<number, Work>> = { 0: "both", 1: "rough", 2: "finish", 3: "finish" };

/** A turning operation of the main program with one cycle, and one call of it. */
export interface TurningUnit {
  /** Its index among the operations of the program. */
  readonly unit: number;
  /** Its index in the run. */
  readonly index: number;
  readonly operation: Operation;
  readonly call: NonNullable<Operation["call"]>;
  readonly cycle: Cycle;
  /** The block that defines the cycle. */
  readonly definition: number;
  readonly statement: StatementOf<"cycle">;
  /** Null for a cycle that does not distinguish roughing and finishing. */
  readonly work: Work | null;
}

/** A program with its result, ready for changes. */
export interface ProgramSituation extends Attempt, Conditions {
  readonly program: Program;
  readonly all: Operations;
  readonly units: readonly TurningUnit[];
  readonly uses: Uses;
}

/** The Q of a cycle that has a role, or null. */
export const qOf = ({ params }: Pick<Cycle, "params">, topic: Topic): string | null =>
  Object.entries<Param>(params).find(([, { shown }]) => shown === topic)?.[0] ?? null;

/** The written number of a role; null where the program computes it, or the cycle lacks it. */
export function writtenNumber({ cycle, statement }: TurningUnit, topic: Topic): { q: string; value: number } | null {
  const q = qOf(cycle, topic);
  const value = statement.parameters.find((p) => p.q === q)?.value;
  return q !== null && typeof value === "number" ? { q, value } : null;
}

/** The number that a role had when the cycle was called; null without one. */
export function calledNumber({ cycle, call }: Pick<TurningUnit, "cycle" | "call">, topic: Topic): number | null {
  const q = qOf(cycle, topic);
  const value = q === null ? undefined : (call.values as Readonly<Record<string, unknown>>)[q];
  return typeof value === "number" ? value : null;
}

/** The operations that a change can take: in the main program, called once, not skipped. */
function turningUnits(program: Program, all: Operations, { operations }: Run): readonly TurningUnit[] {
  const lines = startLines(program);
  return all.units.flatMap((own, unit): readonly TurningUnit[] => {
    const [definition, ...others] = own.definitions;
    if (definition === undefined || others.length > 0 || own.fixedReason !== null || isOff(program, own)) return [];
    const ran = operations.flatMap((operation, index) =>
      operation.definedFile === undefined && operation.definedLine === lines[definition] ? [{ operation, index }] : [],
    );
    const [only] = ran;
    const statement = program.blocks[definition]?.statement;
    if (!only || ran.length > 1 || statement?.kind !== "cycle") return [];
    const { operation, index } = only;
    const cycle = cycleByNumber(statement.cycle);
    const { call } = operation;
    if (!cycle || !call || operation.plan.moves.length === 0) return [];
    const found = { unit, index, operation, call, cycle, definition, statement, work: null };
    return [{ ...found, work: WORKS[calledNumber(found, "operation") ?? -1] ?? null }];
  });
}

/** Reads a program and its result as a situation. */
export function situationOf(program: Program, attempt: Attempt, conditions: Conditions): ProgramSituation {
  const all = operationsOf(program);
  return {
    ...attempt,
    ...conditions,
    program,
    all,
    units: turningUnits(program, all, attempt.run),
    uses: usesOf(attempt.run),
  };
}
