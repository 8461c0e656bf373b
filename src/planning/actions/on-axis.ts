import { catalogue } from "../../cycles/index.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Statement } from "../../nc/statement.ts";
import type { CycleParameter } from "../../nc/words.ts";
import { handCut, speedOnAxis, type AxisWork } from "../../program/edits/hand-operation.ts";
import { exampleJob, type SetJob } from "../../program/job/job.ts";
import { cylinderAround } from "../../program/job/requested-shape.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { at } from "../../kernel/geometry/point.ts";
import { length, rounded } from "../../kernel/units.ts";
import { drillOf } from "../../program/tools/drill-of.ts";
import type { PlanRequest } from "../types.ts";

/** A job that only carries tool, spindle and blank. */
const BASE = catalogue.find(({ group, contour }) => group === "longitudinal" && contour === "own");

/** The tools on the axis of the milling table, without the excluded ones. */
export const drillsOf = ({ shop: { mills = [] }, withoutTools }: PlanRequest): readonly Tool[] =>
  mills.flatMap((row) => drillOf(row) ?? []).filter(({ T }) => !withoutTools.includes(T));

interface AxisCut {
  readonly job: SetJob;
  readonly cut: readonly Statement[];
}

/** The operation of a tool on the axis, with values of its cycle; null without a catalogue. */
export function onAxis(
  work: AxisWork,
  tool: Tool,
  stock: readonly Ring[],
  values: Readonly<Record<string, number>>,
): AxisCut | null {
  if (!BASE) return null;
  const front = frontOf(stock);
  const face = at(front, 0);
  const surface = { site: "face", from: face, to: face } as const;
  const { start, cut } = handCut(work, { stock, surface, tool, sizes: { size: length(0), z: length(0) } });
  const base = exampleJob(BASE);
  const speed = String(speedOnAxis(work, tool));
  return {
    job: {
      ...base,
      tool: tool.T,
      start,
      blank: cylinderAround(stock),
      spindle: { ...base.spindle, mode: "constant", speed },
    },
    cut: cut.map((s) => {
      if (s.kind !== "cycle") return s;
      const valueOf = (p: CycleParameter) => (values[p.q] === undefined ? p.value : rounded(values[p.q] ?? 0));
      return { ...s, parameters: s.parameters.map((p) => ({ ...p, value: valueOf(p) })) };
    }),
  };
}
