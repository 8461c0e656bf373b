import { movedOperation } from "../../../program/edits/operation-edits.ts";
import { changeOf, type Change } from "../change.ts";
import type { ProgramSituation, TurningUnit } from "../situation.ts";

/** What a saved tool change is expected to be worth, s. */
const CHANGE = 12;

const isRoughing = ({ work, cycle }: TurningUnit): boolean => cycle.group !== "thread" && work !== "finish";

/** Operations with one tool side by side. Finishing and threads stay behind the roughing that they follow. */
export function fewerChanges({ program, units }: ProgramSituation): readonly Change[] {
  return units.flatMap((first, i): readonly Change[] => {
    const { T } = first.operation.tool;
    const next = units.findIndex(({ operation }, k) => k > i && operation.tool.T === T);
    const second = units[next];
    if (!second || next === i + 1) return [];
    const between = units.slice(i + 1, next);
    const subject = (of: TurningUnit, beside: TurningUnit) =>
      ({ kind: "fewerChanges", units: [of.unit, beside.unit], tool: T }) as const;
    const earlier = isRoughing(second) || !between.some(isRoughing);
    const later = !isRoughing(first) || between.every(isRoughing);
    return [
      ...(earlier
        ? [changeOf(subject(second, first), CHANGE, () => movedOperation(program, second.unit, first.unit + 1))]
        : []),
      ...(later
        ? [changeOf(subject(first, second), CHANGE - 1, () => movedOperation(program, first.unit, second.unit - 1))]
        : []),
    ];
  });
}
