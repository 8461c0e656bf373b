import { expect, test } from "vitest";
import { newPart, type FinishedPart } from "../../planning/part/finished-part.ts";
import { plannedPart } from "../../planning/part/planned-part.ts";
import { newRow } from "../../program/job/job.ts";
import { adopted, tableId, tableRows, withMark, withTableRows } from "./part-rows.ts";

const part: FinishedPart = {
  ...newPart("SHAFT"),
  outside: [
    newRow("face", { x: "0", z: "0" }),
    newRow("a", { x: "30" }),
    newRow("seat", { z: "-28" }),
    newRow("relief", { kind: "UDC" }),
    newRow("shoulder", { x: "40" }),
    newRow("b", { z: "-60" }),
  ],
  inside: [newRow("x", { x: "10", z: "0" }), newRow("seat bore", { z: "-20" })],
  marks: {
    seat: { tolerance: "h6" },
    relief: { undercut: "DIN 509-F 0.6x0.3" },
    "seat bore": { tolerance: "H7", ra: 1.6 },
  },
};

test("a part from elsewhere gets the ids of the tables, and its undercuts get form and words", () => {
  const own = adopted(part);
  expect(own.outside.map(({ id }) => id)).toEqual(["e1", "e2", "e3", "e4", "e5", "e6"]);
  expect(own.inside.map(({ id }) => id)).toEqual(["i1", "i2"]);
  expect(own.outside[3]).toMatchObject({ kind: "UDC", form: "F" });
  expect(own.marks).toEqual({ e3: { tolerance: "h6" }, i2: { tolerance: "H7", ra: 1.6 } });
  const [was, is] = [plannedPart(part), plannedPart(own)];
  expect(is.part?.rings).toEqual(was.part?.rings);
  expect(is.part?.rings.length).toBeGreaterThan(0);
});

test("an unknown undercut keeps its designation", () => {
  const own = adopted({ ...part, marks: { relief: { undercut: "DIN 1" } } });
  expect(own.marks).toEqual({ e4: { undercut: "DIN 1" } });
});

test("a contour table counts its own rows; marks of deleted rows go", () => {
  const own = adopted(part),
    rows = tableRows(own, "inside");
  expect(rows.map(({ id }) => id)).toEqual(["e1", "e2"]);
  expect(tableId("i2")).toBe("e2");
  const longer = withTableRows(own, "inside", [...rows, newRow("e3", { x: "5" })]);
  expect(longer.inside.map(({ id }) => id)).toEqual(["i1", "i2", "i3"]);
  expect(longer.marks).toBe(own.marks);
  expect(withTableRows(own, "inside", rows.slice(0, 1)).marks).toEqual({ e3: { tolerance: "h6" } });
});

test("an empty mark is removed", () => {
  const own = adopted(part);
  expect(withMark(own, "e3", { thread: "M30" }).marks["e3"]).toEqual({ tolerance: "h6", thread: "M30" });
  expect(withMark(own, "e3", { tolerance: "" }).marks).toEqual({ i2: { tolerance: "H7", ra: 1.6 } });
});
