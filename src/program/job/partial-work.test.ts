import { expect, test } from "vitest";
import type { Cycle } from "../../cycles/define.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import { blankOf, partialWork } from "./partial-work.ts";
import { exampleJob, newRow, type ContourRow } from "./job.ts";
import { readDraft } from "./read-draft.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const cycle = cycleByNumber(820) as Cycle;
const job = exampleJob(cycle);
const nothing = { contour: null, start: null };
const pointsOf = (contour: readonly ContourRow[]) =>
  partialWork(cycle, { ...job, contour }, readDraft(cycle, {}), nothing, shippedTools).points;

test("the blank follows its dimensions, and is empty while they are invalid", () => {
  const blank = { outside: "61.4", bore: "12.2", length: "33.7", allowance: "0.9" };
  expect(blankOf({ ...job, blank })[0]?.map((p) => [p.z.toFixed(3), p.r.toFixed(3)])).toEqual([
    ["-32.800", "6.100"],
    ["0.900", "6.100"],
    ["0.900", "30.700"],
    ["-32.800", "30.700"],
  ]);
  expect(blankOf({ ...job, blank: { ...blank, length: "" } })).toEqual([]);
  expect(blankOf({ ...job, blank: { ...blank, bore: "61.4" } })).toEqual([]);
});

test("the first row of a contour is a point already", () => {
  expect(pointsOf([])).toEqual([]);
  expect(pointsOf([newRow("a", { x: "61.4", z: "-3.3" })])).toEqual([{ z: -3.3, r: 30.7 }]);
  expect(pointsOf([newRow("a", { x: "61.4", z: "-3.3" }), newRow("b", { x: "22.6" })])).toHaveLength(2);
});

test("the tool is the one that the set-up names", () => {
  const known = partialWork(cycle, { ...job, tool: 15 }, readDraft(cycle, {}), nothing, shippedTools);
  expect(known.tool?.T).toBe(15);
  expect(partialWork(cycle, { ...job, tool: 9999 }, readDraft(cycle, {}), nothing, shippedTools).tool).toBeNull();
});
