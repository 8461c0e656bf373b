import type { Cycle } from "../../cycles/define.ts";
import type { SomeValues } from "../../cycles/effect.ts";
import type { Param } from "../../cycles/params.ts";
import { cuttingValues } from "../../planning/values/cutting-values.ts";
import { valuesByParameter } from "../../planning/values/cycle-values.ts";
import { reasoned, type ReasonedNumber } from "../../planning/values/formulas.ts";
import type { ValuesRequest, Work } from "../../planning/values/values-request.ts";
import type { GuidedCut } from "../../app/fields/said/use-advice.ts";
import type { CutMaterial } from "../../program/tools/cutting-table.ts";
import { SPINDLE } from "../../report/advice/advise.ts";

/** A starting value and the prompt, or the spindle, that it is for. */
export interface StartingValue extends ReasonedNumber {
  readonly at: string;
}

const WORK: Partial<Record<Cycle["group"], Work>> = { thread: "thread", recessing: "recess", recessTurning: "recess" };

const numberAt = (values: SomeValues, q: string | undefined) => {
  const value = q === undefined ? undefined : values[q];
  return typeof value === "number" ? value : undefined;
};

/** Starting values of the material alone, while a cycle makes no path. */
function valuesOfMaterial({ params }: Cycle, { roughSpeed, roughFeed, finishFeed }: CutMaterial): StartingValue[] {
  const feeds = { roughingFeed: roughFeed, finishingFeed: finishFeed };
  return [
    { at: SPINDLE, ...reasoned(roughSpeed, "speedOfMaterial", "material", { vc: roughSpeed }) },
    ...Object.entries<Param>(params).flatMap(([at, { shown }]) =>
      shown === "roughingFeed" || shown === "finishingFeed"
        ? [{ at, ...reasoned(feeds[shown], "feedOfMaterial", "material", { f: feeds[shown] }) }]
        : [],
    ),
  ];
}

/** Starting values of a cycle for speed, feeds, infeed and oversize, by their formulas. */
export function startingValues(cycle: Cycle, material: CutMaterial, cut: GuidedCut | null): readonly StartingValue[] {
  if (!cut) return valuesOfMaterial(cycle, material);
  const { tool, machine, table, smallest, largest, values } = cut;
  const [depth, pitch] = [numberAt(values, cycle.thread?.depth), numberAt(values, cycle.thread?.pitch)];
  const request: ValuesRequest = {
    work: WORK[cycle.group] ?? "rough",
    tool,
    material,
    machine,
    smallest,
    largest,
    power: table.power,
    workpiece: null,
    bar: null,
    roughness: null,
    ...(depth !== undefined && { depth }),
    ...(pitch !== undefined && { pitch }),
  };
  const main = cuttingValues(request);
  const finish = cycle.group === "thread" ? main : cuttingValues({ ...request, work: "finish" });
  return [
    ...(main.spindle.kind === "surface" ? [{ at: SPINDLE, ...main.speed }] : []),
    ...valuesByParameter(cycle, { main, finish }).map(([at, value]) => ({ at, ...value })),
  ];
}
