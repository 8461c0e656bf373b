import { describe, expect, test } from "vitest";
import { drillOf } from "./drill-of.ts";
import { drillsBefore, reams } from "./reamed-hole.ts";
import { standardDrills } from "./standard-drills.ts";
import { standardReamers } from "./standard-reamers.ts";
import { readList, shippedList } from "./tool-list.ts";

const rows = [...standardReamers(shippedList), ...standardDrills(shippedList)];
const tools = (readList(rows.map((cells, i) => ({ id: `r${i}`, cells }))).table.mills ?? []).flatMap(
  (row) => drillOf(row) ?? [],
);
const reamers = tools.filter(({ TYPE }) => TYPE === "REAM");
const named = (name: string) => {
  const found = tools.find(({ NAME }) => NAME === name);
  if (!found) throw new Error(name);
  return found;
};

test("usual reamers are rows without a problem, with numbers of their own", () => {
  expect(reamers.length).toBeGreaterThan(8);
  expect(rows.filter(({ TYPE }) => TYPE === "REAM").every(({ T }) => Number(T) > 300)).toBe(true);
  expect(new Set(rows.map(({ T }) => T)).size).toBe(rows.length);
});

test.each(reamers.map((reamer) => [reamer.NAME, reamer] as const))(
  "%s has its drill among the usual ones",
  (_, reamer) => {
    const drills = tools.filter((tool) => tool.TYPE === "DRILL" && drillsBefore(reamer, tool));
    expect(drills.length).toBeGreaterThan(0);
    expect(drills.every(({ CUTLENGTH = 0 }) => CUTLENGTH > (reamer.CUTLENGTH ?? 0))).toBe(true);
  },
);

describe("a reamer", () => {
  test.each([
    ["REAMER-D10-H7", 10.0075, "H7", 1.6, true],
    ["REAMER-D10-H7", 10.0075, "H7", 0.4, false],
    ["REAMER-D10-H7", 10.011, "H8", undefined, true],
    ["REAMER-D10-H7", 10.0045, "H6", undefined, false],
    ["REAMER-D10-H7", 10.05, "+0.1", undefined, false],
    ["REAMER-D10-H7", 10.008, "+0.016", 1.6, true],
    ["REAMER-D10-H7", 10.0125, "+0.02/+0.005", 1.6, false],
    ["REAMER-D10-H7", 10, undefined, 1.6, true],
    ["REAMER-D20-H7", 20, undefined, 1.6, false],
    ["REAMER-D10-H7", 12.009, "H7", 1.6, false],
    ["DRILL-D9.8", 9.8, undefined, undefined, false],
  ] as const)("%s makes ⌀%f %s Ra %s: %s", (name, diameter, tolerance, roughness, expected) => {
    expect(reams(named(name), { diameter, tolerance, roughness })).toBe(expected);
  });

  test.each([
    ["REAMER-D5-H7", "DRILL-D4.8", true],
    ["REAMER-D5-H7", "DRILL-D5", false],
    ["REAMER-D8-H7", "DRILL-D7.8", true],
    ["REAMER-D10-H7", "DRILL-D9.8", true],
    ["REAMER-D10-H7", "DRILL-D9", false],
    ["REAMER-D20-H7", "DRILL-D19.75", true],
  ] as const)("%s follows %s: %s", (reamer, drill, expected) => {
    expect(drillsBefore(named(reamer), named(drill))).toBe(expected);
  });
});
