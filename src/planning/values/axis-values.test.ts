import { expect, test } from "vitest";
import { degrees, length } from "../../kernel/units.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { usualTable } from "../../program/tools/cutting-table.ts";
import { isDeepHole, pecks } from "./axis-values.ts";
import { cuttingValues } from "./cutting-values.ts";
import type { ValuesRequest } from "./values-request.ts";

const drill = (d: number): Tool => ({
  T: 31,
  NAME: "DRILL",
  TYPE: "DRILL",
  TO: 8,
  RS: length(0),
  R: length(d / 2),
  "T-ANGLE": degrees(118),
});
const [material] = usualTable.materials.filter(({ id }) => id === "c45");
const base = {
  smallest: 0,
  largest: 0,
  workpiece: null,
  bar: null,
  machine: null,
  power: 11,
  roughness: null,
} as const;

/* Calculated by hand from the formulas of decision 0056 with C45E: kc1.1 2220, mc 0.14. */
test.each<[string, Pick<ValuesRequest, "work"> & Partial<ValuesRequest>, number, "speed" | "feed", string]>([
  // 240 000 · 0.8 / (23.69 · 26) = 311.7 = 2220 · f^0.86; a pilot of ⌀13 leaves three quarters of it to cut.
  ["a large drill on a weak machine", { work: "drill", power: 0.8 }, 26, "feed", "0.1 feedOfPower"],
  ["the same behind a pilot", { work: "drill", power: 0.8, smallest: 13 }, 26, "feed", "0.14 feedOfPower"],
  // Half of the speed of the drill: 1000 · 12 / (π · 10) = 382
  ["a reamer", { work: "ream" }, 10, "speed", "380 rpmOfSpeed"],
  ["its feed", { work: "ream" }, 10, "feed", "0.2 feedOfReamer"],
  ["a large reamer", { work: "ream" }, 26, "feed", "0.4 feedOfMaterial"],
])("%s", (_, change, across, of, wanted) => {
  if (!material) throw new Error("no such material");
  const { value, formula } = cuttingValues({ ...base, material, tool: drill(across), depth: 40, ...change })[of];
  expect(`${value} ${formula}`).toBe(wanted);
});

test.each([
  [10, 31, true, "20, 5 less, 10 at least"],
  [10, 29, false, "20, 5 less, 10 at least"],
  [5.8, 20, true, "11.6, 2.9 less, 5.8 at least"],
] as const)("a drill of ⌀%f in a hole %f deep clears its chips: %s, by %s", (across, depth, isDeep, wanted) => {
  const { first, less, least } = pecks(drill(across));
  expect(isDeepHole(drill(across), depth)).toBe(isDeep);
  expect(`${first.value}, ${less.value} less, ${least.value} at least`).toBe(wanted);
});
