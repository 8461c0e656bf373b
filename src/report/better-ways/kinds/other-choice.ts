import type { Param, Topic } from "../../../cycles/params.ts";
import { hasNoEffect, type SomeValues } from "../../../cycles/effect.ts";
import { changeOfBlocks, type Change } from "../change.ts";
import { withValues } from "../edits.ts";
import type { ProgramSituation } from "../situation.ts";

/**
 * Choices of a cycle that change its path over the same contour. Smoothing is none of them: without it roughing leaves
 * steps to the finishing cut.
 */
const TOPICS: ReadonlySet<Topic> = new Set<Topic>(["direction", "cuttingLines", "comb"]);
/** Share of its time that an operation is expected to save. */
const SAVED = 0.08;

/** Another choice of a cycle: direction, order of cuts, comb. */
export const otherChoice = (situation: ProgramSituation): readonly Change[] =>
  situation.units.flatMap((of) => {
    const { cycle, statement, operation, unit, call } = of;
    return Object.entries<Param>(cycle.params).flatMap(([q, param]) => {
      const from = statement.parameters.find((p) => p.q === q)?.value;
      if (!TOPICS.has(param.shown) || typeof from !== "number") return [];
      if (hasNoEffect(param, call.values as SomeValues)) return [];
      return (param.choices ?? [])
        .filter((to) => to !== from)
        .map((to) =>
          changeOfBlocks(
            situation.program,
            { kind: "otherChoice", units: [unit], cycle: cycle.number, value: { at: q, from, to } },
            operation.seconds * SAVED,
            [withValues(of, { [q]: to })],
          ),
        );
    });
  });
