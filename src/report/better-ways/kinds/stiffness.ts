import { IN_MM, roundedDown, roundedDownTo } from "../../../kernel/units.ts";
import { valueInProgram } from "../../../program/blocks/cycle-values.ts";
import { depthByWorkpiece } from "../bending.ts";
import { changeOfBlocks, type Change } from "../change.ts";
import { withValues } from "../edits.ts";
import { WORTH } from "../measure.ts";
import { writtenNumber, type ProgramSituation } from "../situation.ts";

/** Step of an infeed, and the least that is offered, mm. */
const STEP = 0.05;
const LEAST = 0.2;

/** A smaller infeed where a slender workpiece bends too far under the passes. */
export const stiffness = (situation: ProgramSituation): readonly Change[] =>
  situation.units.flatMap((of): readonly Change[] => {
    const { cycle, operation, unit } = of;
    const written = writtenNumber(of, "infeed");
    const param = written && cycle.params[written.q];
    const most = roundedDownTo(STEP, depthByWorkpiece(situation, situation.material, operation));
    if (!written || !param || !(operation.plan.infeed > most) || most < LEAST) return [];
    const { unit: length } = situation.run.program;
    const to = valueInProgram(param, most, length === "inch");
    const value = { at: written.q, from: written.value, to, most: roundedDown(most / IN_MM[length]) };
    return [
      changeOfBlocks(
        situation.program,
        { kind: "stiffness", units: [unit], tool: operation.tool.T, value },
        WORTH.bending * (operation.plan.infeed / most - 1),
        [withValues(of, { [written.q]: to })],
      ),
    ];
  });
