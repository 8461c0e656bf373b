import { expect, test } from "vitest";
import { newRow, type ContourRow } from "../../program/job/job.ts";
import { withDuplicatedRow, withRow, withRowMoved, withoutRow } from "./row-edits.ts";

const row = (id: string): ContourRow => newRow(id, { x: id });
const rows = ["e1", "e2", "e3"].map(row);
const ids = (all: readonly ContourRow[]) => all.map((r) => r.id).join();

test("rows are inserted, duplicated, deleted and moved, and the keyboard goes along", () => {
  expect(ids(withRow(rows, 1).rows)).toBe("e1,e4,e2,e3");
  expect(withRow(rows, 1).focus).toBe("e4");
  expect(withDuplicatedRow(rows, 2).rows.at(-1)).toEqual({ ...rows[2], id: "e4" });
  expect(withoutRow(rows, 2)).toEqual({ rows: rows.slice(0, 2), focus: "e2" });
  expect(ids(withRowMoved(rows, 0, 1).rows)).toBe("e2,e1,e3");
  expect(withRowMoved(rows, 2, 1)).toEqual({ rows, focus: "e3" });
  expect(withoutRow([], 0)).toEqual({ rows: [], focus: null });
});
