import type { Program } from "../../../nc/program.ts";
import { isRefused, movedOperation, type Refusal } from "../../../program/edits/operation-edits.ts";
import { changeOf, type Change } from "../change.ts";
import type { ProgramSituation, TurningUnit } from "../situation.ts";

/** What a saved tool change is expected to be worth, s. */
const CHANGE = 12;

const isRoughing = ({ work, cycle }: TurningUnit): boolean => cycle.group !== "thread" && work !== "finish";

/** Operations with one tool, one behind the other. */
function runsOf(units: readonly TurningUnit[]): readonly (readonly TurningUnit[])[] {
  const runs: TurningUnit[][] = [];
  for (const of of units) {
    const [last, before] = [runs.at(-1), runs.at(-1)?.at(-1)];
    if (last && before?.unit === of.unit - 1 && before.operation.tool.T === of.operation.tool.T) last.push(of);
    else runs.push([of]);
  }
  return runs;
}

/** Moves operations one after the other: each from a place to a place. */
function moved(program: Program, moves: readonly (readonly [from: number, to: number])[]): Program | Refusal {
  let made = program;
  for (const [from, to] of moves) {
    const next = movedOperation(made, from, to);
    if (isRefused(next)) return next;
    made = next;
  }
  return made;
}

/** Operations with one tool side by side. Finishing and threads stay behind the roughing that they follow. */
export function fewerChanges({ program, units }: ProgramSituation): readonly Change[] {
  const runs = runsOf(units);
  return runs.flatMap((first, i): readonly Change[] => {
    const T = first[0]?.operation.tool.T;
    const next = runs.findIndex((run, k) => k > i && run[0]?.operation.tool.T === T);
    const [second, last, begin] = [runs[next], first.at(-1), runs[next]?.[0]];
    if (T === undefined || !second || !last || !begin) return [];
    const between = runs.slice(i + 1, next).flat();
    const subject = (own: readonly TurningUnit[], beside: TurningUnit) =>
      ({ kind: "fewerChanges", units: [...own.map(({ unit }) => unit), beside.unit], tool: T }) as const;
    const earlier = second.every(isRoughing) || !between.some(isRoughing);
    const later = !first.some(isRoughing) || between.every(isRoughing);
    return [
      ...(earlier
        ? [
            changeOf(subject(second, last), CHANGE, () =>
              moved(
                program,
                second.map(({ unit }, k) => [unit, last.unit + 1 + k]),
              ),
            ),
          ]
        : []),
      ...(later
        ? [
            changeOf(subject(first, begin), CHANGE - 1, () =>
              moved(
                program,
                first.map(({ unit }, k) => [unit - k, begin.unit - 1]),
              ),
            ),
          ]
        : []),
    ];
  });
}
