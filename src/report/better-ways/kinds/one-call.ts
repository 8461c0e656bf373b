import { part, type Segment } from "../../../kernel/geometry/point.ts";
import { SAME } from "../../../kernel/tolerance.ts";
import { withoutOperation } from "../../../program/edits/operation-edits.ts";
import { changeOf, type Change } from "../change.ts";
import { withNumbers } from "../edits.ts";
import { writtenNumber, type ProgramSituation } from "../situation.ts";
import { withBlock } from "../../../nc/edit.ts";

/** Q215 for roughing and finishing. */
export const BOTH = 0;

/** Whether two contours are equal, element by element. */
export const isSameContour = (a: readonly Segment[], b: readonly Segment[]): boolean =>
  a.length === b.length &&
  a.every((segment, i) => {
    const other = b[i];
    return (
      other !== undefined &&
      segment.kind === other.kind &&
      part.apart(segment.from, other.from) <= SAME &&
      part.apart(segment.to, other.to) <= SAME
    );
  });

/** Roughing and finishing with one tool in one call. */
export const oneCall = ({ program, units }: ProgramSituation): readonly Change[] =>
  units.flatMap((rough, i): readonly Change[] => {
    const finish = units[i + 1];
    if (!finish || rough.work !== "rough" || finish.work !== "finish" || finish.unit !== rough.unit + 1) return [];
    const { operation: a } = rough;
    const { operation: b } = finish;
    const [work, feed] = [writtenNumber(rough, "operation"), writtenNumber(rough, "finishingFeed")];
    const finishing = writtenNumber(finish, "finishingFeed");
    if (a.cycle !== b.cycle || a.tool.T !== b.tool.T || !isSameContour(a.plan.contour, b.plan.contour)) return [];
    if (!work || !feed || !finishing) return [];
    const both = withNumbers(rough.statement, { [work.q]: BOTH, [feed.q]: finishing.value });
    return [
      changeOf({ kind: "oneCall", units: [rough.unit, finish.unit] }, 5, () =>
        withoutOperation(withBlock(program, rough.definition, both), finish.unit),
      ),
    ];
  });
