import type { Program } from "../../../nc/program.ts";
import { isRefused } from "../../../program/edits/operation-edits.ts";
import { changeOf, type Change } from "../change.ts";
import { retooled } from "../edits.ts";
import type { Fits } from "../fits.ts";
import type { ProgramSituation } from "../situation.ts";

/** What a tool less is expected to be worth, s. */
const TOOL = 60;

/** A tool can go when tools that the program calls anyway do all its operations. */
export function fewerTools({ program, all, units, uses, run }: ProgramSituation, fits: Fits): readonly Change[] {
  return uses.tools.flatMap((gone) => {
    const own = units.filter(({ operation }) => operation.tool.T === gone);
    // Every move with the tool belongs to an operation that can be changed.
    const inUnits = new Set(own.flatMap(({ unit }) => all.units[unit]?.section ?? []));
    const sections = new Set(all.units.flatMap(({ section, toolCall }) => (toolCall === null ? [] : [section])));
    const steps = run.operations.filter(({ tool }) => tool.T === gone).length;
    if (own.length === 0 || steps !== own.length || inUnits.size === sections.size) return [];
    const others = own.map((each) => fits(each).filter((fit) => fit.makesContour));
    if (others.some((found) => found.length === 0)) return [];
    const byOne = uses.tools
      .map((T) => others.flatMap((found) => found.find(({ tool }) => tool.T === T) ?? []))
      .filter((found) => found.length === own.length);
    const fastest = others.flatMap((found) => found.toSorted((a, b) => a.seconds - b.seconds)[0] ?? []);
    // Operations that no tool does together are given to several.
    return (byOne.length > 0 ? byOne : [fastest]).map((found) => {
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
      const tools = [...new Set(found.map(({ tool }) => tool.T))];
      const units = own.map(({ unit }) => unit);
      return changeOf({ kind: "fewerTools", units, tools, instead: gone }, TOOL - slower, edit);
    });
  });
}
