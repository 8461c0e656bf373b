import { changeOf, type Change } from "../change.ts";
import { retooled } from "../edits.ts";
import type { Fits } from "../fits.ts";
import { LEAST } from "../measure.ts";
import type { ProgramSituation } from "../situation.ts";

/** What a saved tool change is expected to be worth, s. */
const CHANGE = 8;

/** Another tool for one operation: faster, or one that is in the spindle already. */
export function otherTool({ program, units, run }: ProgramSituation, fits: Fits): readonly Change[] {
  return units.flatMap((of) => {
    const { unit, index, operation } = of;
    const [before, after] = [run.operations[index - 1]?.tool.T, run.operations[index + 1]?.tool.T];
    return fits(of)
      .filter(({ makesContour }) => makesContour)
      .flatMap(({ tool, seconds }) => {
        const faster = operation.seconds - seconds;
        const expected = faster + (tool.T === before || tool.T === after ? CHANGE : 0);
        if (expected < LEAST.seconds) return [];
        const subject = { kind: "otherTool", units: [unit], tool: tool.T, instead: operation.tool.T } as const;
        return [changeOf(subject, expected, () => retooled(program, unit, of, tool))];
      });
  });
}
