import { duplicatedOperation, isRefused } from "../../../program/edits/operation-edits.ts";
import { remedies, type Remedy } from "../../remedies.ts";
import { changeOf, type Change } from "../change.ts";
import { retooled, withNumbersIn } from "../edits.ts";
import { depthOf, suitsWork } from "../fits.ts";
import { LEAST } from "../measure.ts";
import { qOf, type ProgramSituation, type TurningUnit } from "../situation.ts";

/** Most regions and tools per region that are looked at: each costs a cut per tool. */
const MOST_REGIONS = 8;
const MOST_TOOLS = 3;
/** Q215 for finishing only. */
const FINISH = 2;
/** What a mm² of residual material is expected to be worth, s. */
const PER_AREA = 60;

/** The tools that take residual material: those of the program first, then the one that leaves least. */
function best(found: readonly Remedy[], used: ReadonlySet<number>): readonly Remedy[] {
  const own = found.filter(({ tool }) => used.has(tool.T));
  return [...new Set([...own, ...found])].slice(0, MOST_TOOLS);
}

/** Residual material goes with another tool: in the operation that leaves it, or in one more behind it. */
export function restOperation(situation: ProgramSituation): readonly Change[] {
  const { program, units, tools, uses, simulation } = situation;
  const used = new Set(uses.tools);
  const find = remedies(tools);
  const left = simulation.proof.residual
    .filter(({ isAsked, area }) => !isAsked && area >= LEAST.residual)
    .toSorted((a, b) => b.area - a.area)
    .slice(0, MOST_REGIONS);
  return left.flatMap((region) => {
    const of = units.find(({ index }) => index === region.operation);
    if (!of) return [];
    const { unit, operation } = of;
    const q = qOf(of.cycle, "operation");
    const found = find(operation, region);
    const suiting = (work: TurningUnit["work"]) =>
      best(
        found.filter(({ tool }) => suitsWork(of, tool, depthOf(operation.plan), work)),
        used,
      );
    const expected = ({ residualArea, tool }: Remedy) =>
      PER_AREA * (region.area - residualArea) + (used.has(tool.T) ? 1 : 0);
    const instead = suiting(of.work).map((remedy) => {
      const { tool } = remedy;
      const subject = { kind: "otherTool", units: [unit], tool: tool.T, instead: operation.tool.T } as const;
      return changeOf(subject, expected(remedy) + 1, () => retooled(program, unit, of, tool));
    });
    const more = ([FINISH, null] as const).flatMap((work) =>
      suiting(work === FINISH ? "finish" : of.work).map((remedy) => {
        const edit = () => {
          const twice = duplicatedOperation(program, unit);
          if (isRefused(twice) || (work !== null && q === null)) return null;
          const worked = work !== null && q !== null ? withNumbersIn(twice, unit + 1, { [q]: work }) : twice;
          return retooled(worked, unit + 1, of, remedy.tool);
        };
        const subject = { kind: "restOperation", units: [unit], tool: remedy.tool.T } as const;
        return changeOf(subject, expected(remedy), edit);
      }),
    );
    return [...instead, ...more];
  });
}
