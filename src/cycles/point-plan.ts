import { flat, segmentToFlat, toPart } from "../kernel/geometry/flat.ts";
import type { Plan } from "../kernel/plan/plan.ts";
import { POINT_TOOL } from "../kernel/strategy/oversize-contour.ts";
import type { Cycle, Given, Outline } from "./define.ts";
import type { Params, Values } from "./params.ts";

/** Q215 = 1. */
const ROUGHING = 1;

/**
 * The plan of a cycle for a point instead of a tool: a picture of the values shows levels, area and reach before a tool
 * is chosen. The point starts at the start of the contour, at its greatest height, and always roughs.
 */
export function pointPlan(cycle: Cycle, values: Values<Params>, { contour, frame }: Outline, given: Given): Plan {
  const elements = contour.map((s) => segmentToFlat(frame, s));
  const first = elements[0]?.from ?? { u: 0, v: 0 };
  const highest = Math.max(first.v, ...elements.map((s) => flat.boxOf(s).high));
  const operation = Object.keys(cycle.params).filter((q) => cycle.params[q]?.shown === "operation");
  const roughing = { ...values, ...Object.fromEntries(operation.map((q) => [q, ROUGHING])) } as Values<Params>;
  const start = toPart(frame, { u: first.u, v: highest });
  return cycle.plan(roughing, { tool: POINT_TOOL, start, feedUnit: "mm/rev", autoFeed: null, stock: null }, given);
}
