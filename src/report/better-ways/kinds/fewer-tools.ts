import type { Program } from "../../../nc/program.ts";
import { isRefused } from "../../../program/edits/operation-edits.ts";
import { changeOf, type Change } from "../change.ts";
import { retooled } from "../edits.ts";
import type { Fits } from "../fits.ts";
import type { ProgramSituation } from "../situation.ts";

/** A tool can go when one that the program calls anyway does all its operations. */
export function fewerTools({ program, all, units, uses, run }: ProgramSituation, fits: Fits): readonly Change[] {
  return uses.tools.flatMap((gone) => {
    const own = units.filter(({ operation }) => operation.tool.T === gone);
    // Every move with the tool belongs to an operation that can be changed.
    const inUnits = new Set(own.flatMap(({ unit }) => all.units[unit]?.section ?? []));
    const sections = new Set(all.units.flatMap(({ section, toolCall }) => (toolCall === null ? [] : [section])));
    const steps = run.operations.filter(({ tool }) => tool.T === gone).length;
    if (own.length === 0 || steps !== own.length || inUnits.size === sections.size) return [];
    return uses.tools
      .filter((tool) => tool !== gone)
      .flatMap((tool) => {
        const found = own.map((each) => fits(each).find((fit) => fit.tool.T === tool && fit.makesContour));
        if (found.some((fit) => fit === undefined)) return [];
        const edit = (): Program | null => {
          let made = program;
          for (const [i, each] of own.entries()) {
            const fit = found[i];
            const next = fit ? retooled(made, each.unit, each, fit.tool) : made;
            if (isRefused(next)) return null;
            made = next;
          }
          return made;
        };
        const slower = own.reduce((sum, { operation }, i) => sum + (found[i]?.seconds ?? 0) - operation.seconds, 0);
        const subject = { kind: "fewerTools", units: own.map(({ unit }) => unit), tool, instead: gone } as const;
        return [changeOf(subject, 60 - slower, edit)];
      });
  });
}
