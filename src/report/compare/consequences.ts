import { startLines, type Program } from "../../nc/program.ts";
import type { ComparedOperation } from "../../program/compare/by-operation.ts";
import { operationsOf, wholeOf } from "../../program/edits/operations.ts";
import { fileKey } from "../../program/state/program-files.ts";
import type { Run } from "../../program/state/run-types.ts";
import type { Simulation } from "../../sim/simulation.ts";

/** The effects of a stretch of a program: passes, deepest infeed in mm, seconds, residual material in mm². */
export interface Effects {
  readonly passes: number;
  readonly infeed: number;
  readonly seconds: number;
  readonly residue: number;
}

/** The effects of an operation before and after a change; null where it does not run. */
export interface Consequence {
  readonly before: Effects | null;
  readonly after: Effects | null;
}

/** A program run with its simulation. */
export interface ProgramRun {
  readonly run: Run;
  readonly simulation: Pick<Simulation, "proof">;
}

/**
 * The effects of each operation defined in a text, by its index; -1: moves outside operations. `file`: a called
 * program, null for the main one.
 */
export function effectsByUnit(
  { run, simulation }: ProgramRun,
  program: Program,
  file: string | null,
): ReadonlyMap<number, Effects> {
  const lines = startLines(program);
  const all = operationsOf(program);
  const unitOf = (line: number): number => {
    const next = lines.findIndex((start) => start > line);
    const index = (next < 0 ? lines.length : next) - 1;
    return all.units.findIndex((_, unit) => {
      const { from, to } = wholeOf(all, unit);
      return index >= from && index < to;
    });
  };
  const effects = new Map<number, Effects>();
  run.operations.forEach((operation, i) => {
    const own = operation.definedFile === undefined ? null : fileKey(operation.definedFile);
    if (own !== (file === null ? null : fileKey(file)) || operation.plan.moves.length === 0) return;
    const unit = unitOf(operation.definedLine);
    const before = effects.get(unit) ?? { passes: 0, infeed: 0, seconds: 0, residue: 0 };
    const residue = simulation.proof.residual.reduce((sum, r) => (r.operation === i ? sum + r.area : sum), 0);
    effects.set(unit, {
      passes: before.passes + operation.plan.passes,
      infeed: Math.max(before.infeed, operation.plan.infeed),
      seconds: before.seconds + operation.seconds,
      residue: before.residue + residue,
    });
  });
  return effects;
}

/** The effects of the whole program. */
export const effectsOf = ({ run, simulation }: ProgramRun): Effects => ({
  passes: run.operations.reduce((sum, { plan }) => sum + plan.passes, 0),
  infeed: run.operations.reduce((most, { plan }) => Math.max(most, plan.infeed), 0),
  seconds: run.seconds,
  residue: simulation.proof.residual.reduce((sum, { area }) => sum + area, 0),
});

export const consequenceOf = (
  { a, b }: ComparedOperation,
  before: ReadonlyMap<number, Effects>,
  after: ReadonlyMap<number, Effects>,
): Consequence => ({ before: before.get(a?.place ?? -1) ?? null, after: after.get(b?.place ?? -1) ?? null });

/** Smaller differences are not displayed: mm, s, mm². */
const SHOWN = { infeed: 0.0005, seconds: 0.05, residue: 0.005 } as const;

/** The effects with a displayed difference, in display order. */
export function changedEffects({ before, after }: Consequence): readonly (keyof Effects)[] {
  if (!before || !after) return before || after ? ["infeed", "passes", "seconds", "residue"] : [];
  const differs = (name: keyof Effects) =>
    name === "passes" ? before.passes !== after.passes : Math.abs(before[name] - after[name]) >= SHOWN[name];
  return (["infeed", "passes", "seconds", "residue"] as const).filter(differs);
}
