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

test("taps have diameter and pitch of their thread, and a drill for its core", () => {
  const rows = standardDrills(shippedList);
  const taps = rows.filter(({ TYPE }) => TYPE === "TAP").map(({ NAME, R, PITCH }) => [NAME, R, PITCH]);
  expect(taps).toEqual([
    ["TAP-M6", "3", "1"],
    ["TAP-M8", "4", "1.25"],
    ["TAP-M10", "5", "1.5"],
    ["TAP-M12", "6", "1.75"],
    ["TAP-M3", "1.5", "0.5"],
    ["TAP-M4", "2", "0.7"],
    ["TAP-M5", "2.5", "0.8"],
    ["TAP-M16", "8", "2"],
    ["TAP-M20", "10", "2.5"],
  ]);
  const drills = rows.filter(({ TYPE }) => TYPE === "DRILL").map(({ R }) => Number(R));
  for (const [, R, PITCH] of taps) {
    const core = Number(R) - Number(PITCH) / 2;
    expect(drills.some((r) => Math.abs(r - core) <= 0.03)).toBe(true);
  }
});
