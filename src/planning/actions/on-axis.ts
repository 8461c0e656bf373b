import { catalogue } from "../../cycles/index.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Statement } from "../../nc/statement.ts";
import { handCut, speedOnAxis, type AxisWork } from "../../program/edits/hand-operation.ts";
import { exampleJob, type SetJob } from "../../program/job/job.ts";
import { cylinderAround } from "../../program/job/requested-shape.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { at } from "../../kernel/geometry/point.ts";
import { length, radius, rounded, toDiameter } from "../../kernel/units.ts";
import { drillOf } from "../../program/tools/drill-of.ts";
import type { PlanRequest, ReasonedValue } from "../types.ts";
import { clearRadius } from "./bore.ts";
import { pecks } from "../values/axis-values.ts";
import { withCuttingValues } from "../values/cycle-values.ts";
import { valuesOf } from "./values-of-job.ts";

/** A job that only carries tool, spindle and blank. */
const BASE = catalogue.find(({ group, contour }) => group === "longitudinal" && contour === "own");

/** The tools on the axis of the milling table, without the excluded ones. */
export const drillsOf = ({ shop: { mills = [] }, withoutTools }: PlanRequest): readonly Tool[] =>
  mills.flatMap((row) => drillOf(row) ?? []).filter(({ T }) => !withoutTools.includes(T));

interface AxisCut {
  /** The drilling cycle. */
  readonly cycle: number | null;
  readonly job: SetJob;
  readonly cut: readonly Statement[];
  readonly values: readonly ReasonedValue[];
}

/**
 * The operation of a tool on the axis to a depth below the front, with its cutting values; `set`: other values of its
 * cycle. Null where that cycle is excluded.
 */
export function onAxis(
  work: AxisWork,
  tool: Tool,
  depth: number,
  stock: readonly Ring[],
  request: PlanRequest,
  set: Readonly<Record<string, number>> = {},
): AxisCut | null {
  if (!BASE) return null;
  const front = frontOf(stock);
  const face = at(front, 0);
  const surface = { site: "face", from: face, to: face } as const;
  const { start, cut } = handCut(work, { stock, surface, tool, sizes: { size: length(0), z: length(0) } });
  const cycle = cut.find((s) => s.kind === "cycle")?.cycle ?? null;
  if (cycle !== null && request.withoutCycles.includes(cycle)) return null;
  const base = { ...exampleJob(BASE), tool: tool.T, start, blank: cylinderAround(stock) };
  const fixed = { Q201: -depth, Q203: front, ...set };
  const filled = (values: Readonly<Record<string, number | undefined>>) => cut.map((s) => withParameters(s, values));
  if (work === "tap") {
    const spindle = { ...base.spindle, mode: "constant", speed: String(speedOnAxis(work, tool)) } as const;
    return { cycle, job: { ...base, spindle }, cut: filled(fixed), values: [] };
  }
  const across = toDiameter(radius(tool.R ?? 0));
  const largest = work === "centre" ? (tool.centre?.hole.d2 ?? across) : across;
  const hole = clearRadius(stock, front - depth, front);
  const pilot = Number.isFinite(hole) ? toDiameter(radius(hole)) : 0;
  const valued = work === "peck" ? "drill" : work;
  const main = valuesOf(tool, { operation: "both", work: valued, smallest: pilot, largest, stock, depth }, request);
  const { job, values } = withCuttingValues(base, { params: {} }, { main });
  const { first, less, least } = pecks(tool);
  const own = {
    Q206: main.feed,
    ...(work === "drill" && main.step && { Q202: main.step }),
    ...(work === "peck" && { Q202: first, Q212: less, Q205: least }),
  };
  const reasoned = Object.entries(own).map(([q, { value, formula, inputs }]) => ({ q, value, formula, inputs }));
  const numbers = Object.fromEntries(reasoned.map(({ q, value }) => [q, value]));
  return { cycle, job, cut: filled({ ...numbers, ...fixed }), values: [...reasoned, ...values] };
}

/** A drilling cycle with some of its values. */
function withParameters(s: Statement, values: Readonly<Record<string, number | undefined>>): Statement {
  if (s.kind !== "cycle") return s;
  const parameters = s.parameters.map((p) => {
    const value = values[p.q];
    return value === undefined ? p : { ...p, value: rounded(value) };
  });
  return { ...s, parameters };
}
