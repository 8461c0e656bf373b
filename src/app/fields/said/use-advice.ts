import { useMemo } from "react";
import { cycleByNumber } from "../../../cycles/index.ts";
import type { SomeValues } from "../../../cycles/effect.ts";
import type { Plan } from "../../../kernel/plan/plan.ts";
import { radius, toDiameter } from "../../../kernel/units.ts";
import type { Operation } from "../../../program/state/run-types.ts";
import { advise, type Advice, type Advised } from "../../../report/advice/advise.ts";
import {
  readCuttingTable,
  usualTable,
  type CutMaterial,
  type CuttingTable,
} from "../../../program/tools/cutting-table.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useEditor, openContent } from "../../document/store.ts";
import { useIsGuidedCall } from "./open-call.ts";

/** The cutting data of this device: the shop's own, or the default ones. */
export function useCuttingTable(): CuttingTable {
  const text = useSettings((s) => s.cutting);
  return useMemo(() => (text === "" ? null : readCuttingTable(text)) ?? usualTable, [text]);
}

const named = ({ materials }: CuttingTable, id: string | undefined): CutMaterial | undefined =>
  materials.find((each) => each.id === id);

/** Material of the open work, or the default material; `own` is the id stated by the work. */
export function useMaterialOfWork(): { readonly material: CutMaterial; readonly own: string | undefined } {
  const table = useCuttingTable();
  const own = useEditor((s) => openContent(s)?.material);
  const device = useSettings((s) => s.material);
  const first = (table.materials[0] ?? usualTable.materials[0]) as CutMaterial;
  return { material: named(table, own) ?? named(table, device) ?? first, own: named(table, own) && own };
}

/** Advice for one call of a cycle. */
export interface AdvisedCall extends Pick<Operation, "definedLine" | "definedFile"> {
  readonly operation: number;
  readonly cycle: number;
  readonly advice: readonly Advice[];
}

type CutDiameters = Pick<Advised, "smallest" | "largest">;
/** Cached by plan; unchanged plans keep their identity between runs. */
const diameters = new WeakMap<Plan, CutDiameters>();

/** The diameters between which an operation cuts, mm. */
function diametersOf({ plan, start }: Operation): CutDiameters {
  const known = diameters.get(plan);
  if (known) return known;
  let [from, least, most] = [start, Infinity, 0];
  for (const { kind, to } of plan.moves) {
    const [a, b] = [Math.abs(from.r), Math.abs(to.r)];
    if (kind !== "rapid") [least, most] = [Math.min(least, a, b), Math.max(most, a, b)];
    from = to;
  }
  const found = { smallest: toDiameter(radius(least)), largest: toDiameter(radius(most)) };
  diameters.set(plan, found);
  return found;
}

/** The cut of an operation, on which advice and starting values are based. */
export type GuidedCut = Pick<Advised, "values" | "tool" | "smallest" | "largest" | "machine" | "material" | "table">;

/** The cut of the call that the guide of a cycle refers to; null while it makes no path. */
export function useGuidedCut(cycle: number): GuidedCut | null {
  const run = useOutcome((s) => s.newest?.run);
  const isMeant = useIsGuidedCall(cycle);
  const table = useCuttingTable();
  const { material } = useMaterialOfWork();
  const found = run?.operations.find((each) => isMeant(each) && each.call && each.plan.moves.length > 0);
  if (!run || !found?.call) return null;
  const { tool, call } = found;
  const values = call.values as SomeValues;
  return { values, tool, ...diametersOf(found), machine: run.timing.turning, material, table };
}

/** Advice on every call of the open work; nothing while it makes no path. */
export function useAdvisedCalls(): readonly AdvisedCall[] {
  const run = useOutcome((s) => s.newest?.run);
  const isOpen = useEditor((s) => s.work !== null);
  const table = useCuttingTable();
  const { material } = useMaterialOfWork();
  return useMemo(() => {
    if (!run || !isOpen) return [];
    return run.operations.flatMap((each, operation): readonly AdvisedCall[] => {
      const cycle = cycleByNumber(each.cycle);
      if (!cycle || !each.call || each.plan.moves.length === 0) return [];
      const advice = advise({
        cycle,
        values: each.call.values as SomeValues,
        tool: each.tool,
        spindle: each.spindle,
        perRevolution: each.feedUnit === "mm/rev",
        depth: each.plan.infeed,
        ...diametersOf(each),
        machine: run.timing.turning,
        material,
        table,
      });
      const { definedLine, definedFile } = each;
      return [{ operation, cycle: each.cycle, definedLine, ...(definedFile !== undefined && { definedFile }), advice }];
    });
  }, [run, isOpen, table, material]);
}

/** Advice on one parameter of a cycle, for the call that the guide refers to. */
export function useAdviceOn(cycle: number, q: string): readonly Advice[] {
  const isMeant = useIsGuidedCall(cycle);
  return (
    useAdvisedCalls()
      .find(isMeant)
      ?.advice.filter(({ at }) => at === q) ?? []
  );
}
