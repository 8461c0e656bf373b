import type { Cycle } from "../../cycles/define.ts";
import type { Param, Topic } from "../../cycles/params.ts";
import type { SetJob } from "../../program/job/job.ts";
import { withCycleValues } from "../../program/job/requested-job.ts";
import type { ReasonedValue } from "../types.ts";
import type { ReasonedNumber } from "./formulas.ts";
import type { CuttingValues } from "./values-request.ts";

/** Values for the operations of a cycle: of its roughing, or of its only work, and of its finishing where it has both. */
export interface ValuesOfCycle {
  readonly main: CuttingValues;
  readonly finish?: CuttingValues;
}

/** What the topics of a cycle take. A feed of 0 at the plunging prompt means the feed of the work. */
const TAKEN: Partial<Record<Topic, (values: ValuesOfCycle) => ReasonedNumber | null | undefined>> = {
  infeed: ({ main }) => main.infeed,
  depthLimit: ({ main }) => main.step,
  roughingFeed: ({ main }) => main.feed,
  finishingFeed: ({ main, finish }) => (finish ?? main).feed,
  plungingFeed: ({ main }) => main.plungeFeed,
  oversizeDiameter: ({ main, finish }) => (finish ?? main).oversize?.diameter,
  oversizeZ: ({ main, finish }) => (finish ?? main).oversize?.z,
};

const asValue = (q: string, { value, formula, inputs }: ReasonedNumber): ReasonedValue => ({
  q,
  value,
  formula,
  inputs,
});

/** The values of a cycle by its parameters. */
export const valuesByParameter = (
  { params }: Pick<Cycle, "params">,
  values: ValuesOfCycle,
): readonly (readonly [q: string, value: ReasonedNumber])[] =>
  Object.entries<Param>(params).flatMap(([q, { shown, reserved }]) => {
    const taken = reserved ? null : TAKEN[shown]?.(values);
    return taken ? [[q, taken] as const] : [];
  });

/** The same with the speed and its limit. */
export function reasonedValues(cycle: Pick<Cycle, "params">, values: ValuesOfCycle): readonly ReasonedValue[] {
  const { speed, limit } = values.main;
  return [
    ...valuesByParameter(cycle, values).map(([q, value]) => asValue(q, value)),
    asValue("speed", speed),
    ...(limit ? [asValue("limit", limit)] : []),
  ];
}

/** The job of a cycle with its cutting values and its spindle. */
export function withCuttingValues(
  job: SetJob,
  cycle: Pick<Cycle, "params">,
  values: ValuesOfCycle,
): { readonly job: SetJob; readonly values: readonly ReasonedValue[] } {
  const reasoned = reasonedValues(cycle, values);
  const { spindle } = values.main;
  const filled = withCycleValues(
    job,
    reasoned.flatMap(({ q, value }) => (q in cycle.params ? [[q, value] as const] : [])),
  );
  return {
    job: {
      ...filled,
      perRevolution: true,
      spindle:
        spindle.kind === "constant"
          ? { ...job.spindle, mode: "constant", speed: String(spindle.speed) }
          : {
              ...job.spindle,
              mode: "surface",
              cuttingSpeed: String(spindle.cuttingSpeed),
              limit: String(spindle.limit),
            },
    },
    values: reasoned,
  };
}
