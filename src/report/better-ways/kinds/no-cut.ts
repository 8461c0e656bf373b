import { REAL_AREA } from "../../../kernel/area/real-area.ts";
import { withoutOperation } from "../../../program/edits/operation-edits.ts";
import { changeOf, type Change } from "../change.ts";
import type { Situation } from "../situation.ts";

/** An operation that removes nothing can go. A thread cuts grooves that the stock does not count. */
export const noCut = ({ program, units, simulation: { proof } }: Situation): readonly Change[] =>
  units
    .filter(({ cycle, index }) => {
      const own = proof.operations[index];
      return cycle.group !== "thread" && own !== undefined && !own.hasFailed && own.cut < REAL_AREA;
    })
    .flatMap(({ unit, operation }) =>
      changeOf(program, { kind: "noCut", units: [unit] }, withoutOperation(program, unit), operation.seconds + 60),
    );
