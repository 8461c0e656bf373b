import { expect, test } from "vitest";
import { at, type Pt } from "../kernel/geometry/point.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { cycleByNumber } from "./index.ts";

/** Where the area and the contour of a cycle begin along the cut, for a tool that starts in front of them. */
function begins(number: number, start: Pt, along: "z" | "r"): { area: number; contour: number } {
  const cycle = cycleByNumber(number);
  const tool = shippedTools.find((t) => t.T === cycle?.setup.tool);
  if (!cycle || !tool) throw new Error(`no cycle ${number}`);
  const example = Object.fromEntries(Object.entries(cycle.params).map(([q, p]) => [q, p.example]));
  const values = { ...example, ...cycle.setup.values };
  const plan = cycle.plan(
    values as never,
    { tool, start, feedUnit: "mm/rev", autoFeed: null, stock: null },
    { contour: null, start },
  );
  expect(plan.issues.filter((i) => i.severity === "error")).toEqual([]);
  return { area: Math.max(...plan.area.map((p) => p[along])), contour: plan.contour[0]?.from[along] ?? NaN };
}

test("material in front of a shoulder is cut from the start point on", () => {
  expect(begins(812, at(6.3, 40), "z").area).toBeCloseTo(6.3, 6);
  expect(begins(822, at(4, 44.2), "r").area).toBeCloseTo(44.2, 6);
});

test("material in front of a plunging contour is never cut, from any start point", () => {
  for (const { area, contour } of [begins(814, at(6.3, 40), "z"), begins(824, at(4, 44.2), "r")])
    expect(area).toBeCloseTo(contour, 6);
});
