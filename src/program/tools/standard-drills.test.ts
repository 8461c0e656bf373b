import { expect, test } from "vitest";
import { drillOf } from "./drill-of.ts";
import { standardDrills } from "./standard-drills.ts";
import { mergedTools, readList, shippedList } from "./tool-list.ts";

test("every standard drill and tap is a callable tool, beside those of the table", () => {
  const rows = standardDrills(shippedList);
  const { list, replaced, added } = mergedTools(shippedList, rows);
  expect([replaced, added]).toEqual([0, rows.length]);
  const { table, mills } = readList(list);
  expect([...table.refused]).toEqual([]);
  const drills = mills.flatMap((row) => drillOf(row) ?? []);
  expect(drills.map(({ NAME }) => NAME)).toEqual(rows.map(({ NAME }) => NAME));
  expect(drills.filter(({ TYPE }) => TYPE === "TAP").every(({ PITCH }) => PITCH !== undefined)).toBe(true);
});

test("numbers of the table stay free of standard drills", () => {
  const list = [...shippedList, { id: "x", cells: { T: "31", NAME: "MINE", TYPE: "MILL", R: "4" } }];
  expect(standardDrills(list)[0]?.T).toBe("32");
  expect(standardDrills(list).map(({ T }) => T)).not.toContain("31");
});
