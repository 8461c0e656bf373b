import { movedOperation } from "../../../program/edits/operation-edits.ts";
import { changeOf, type Change } from "../change.ts";
import type { ProgramSituation, TurningUnit } from "../situation.ts";

/** What a saved tool change is expected to be worth, s. */
const CHANGE = 12;

const isRoughing = ({ work, cycle }: TurningUnit): boolean => cycle.group !== "thread" && work !== "finish";

/** Operations with one tool side by side. Finishing and threads stay behind the roughing that they follow. */
export function fewerChanges({ program, units }: ProgramSituation): readonly Change[] {
  return units.flatMap((first, i) =>
    units.slice(i + 2).flatMap((second, k): readonly Change[] => {
      const between = units.slice(i + 1, i + 2 + k);
      const { T } = first.operation.tool;
      if (second.operation.tool.T !== T || between.some(({ operation }) => operation.tool.T === T)) return [];
      const subject = (of: TurningUnit, beside: TurningUnit) =>
        ({ kind: "fewerChanges", units: [of.unit, beside.unit], tool: T }) as const;
      const earlier = isRoughing(second) || !between.some(isRoughing);
      const later = !isRoughing(first) || between.every(isRoughing);
      return [
        ...(earlier
          ? changeOf(program, subject(second, first), movedOperation(program, second.unit, first.unit + 1), CHANGE)
          : []),
        ...(later
          ? changeOf(program, subject(first, second), movedOperation(program, first.unit, second.unit - 1), CHANGE - 1)
          : []),
      ];
    }),
  );
}
