import { REAL_AREA } from "../../../kernel/area/real-area.ts";
import { withoutOperation } from "../../../program/edits/operation-edits.ts";
import { changeOf, type Change } from "../change.ts";
import type { ProgramSituation } from "../situation.ts";

/**
 * An operation that removes nothing can go. A thread cuts grooves that the stock does not count; an operation with
 * faults, or behind a part that came off, was meant to cut.
 */
export function noCut({ program, units, simulation: { proof, findings } }: ProgramSituation): readonly Change[] {
  const isFaulty = (index: number) => findings.some(({ operation }) => operation === index);
  const isOff = (step: number) => proof.loose.some((piece) => piece.step <= step);
  return units
    .filter(({ cycle, index, operation: { issues, firstStep } }) => {
      const own = proof.operations[index];
      const fails = issues.some(({ severity }) => severity === "error") || isFaulty(index) || isOff(firstStep);
      return cycle.group !== "thread" && !fails && own !== undefined && !own.hasFailed && own.cut < REAL_AREA;
    })
    .map(({ unit, operation }) =>
      changeOf({ kind: "noCut", units: [unit] }, operation.seconds + 60, () => withoutOperation(program, unit)),
    );
}
