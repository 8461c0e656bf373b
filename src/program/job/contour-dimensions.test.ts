import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { dimensionsOf, dimensionTyped, holdsOf } from "./contour-dimensions.ts";
import { readRows, type RowField } from "./contour-rows.ts";
import { newRow, type ContourRow } from "./job.ts";

const row = (id: string, given: Partial<ContourRow> = {}) => newRow(id, given);
const shaft = [
  row("e1", { x: "17.43", z: "0" }),
  row("e2", { z: "-23.617" }),
  row("e3", { kind: "RND", r: "1.35" }),
  row("e4", { x: "41.9" }),
  row("e5", { x: "58.07", z: "-51.3" }),
];
const shown = (rows: readonly ContourRow[], i: number) =>
  Object.fromEntries(dimensionsOf(rows, readRows(rows), i).map((d) => [d.field, d.follows ? `(${d.text})` : d.text]));
const typed = (rows: readonly ContourRow[], i: number, field: RowField, text: string) =>
  dimensionTyped(rows, readRows(rows), i, field, text);
const endOf = (rows: readonly ContourRow[], i: number) => readRows(rows).rows[i]?.end;

describe("the dimensions of an element", () => {
  test("what is typed stands as typed, what stays or follows in brackets", () => {
    expect(shown(shaft, 0)).toEqual({ x: "17.43", z: "0" });
    expect(shown(shaft, 1)).toEqual({ x: "(17.43)", z: "-23.617", length: "(23.617)", angle: "(180)" });
    expect(shown(shaft, 2)).toEqual({ r: "1.35" });
    expect(shown(shaft, 4)).toMatchObject({ x: "58.07", z: "-51.3" });
  });

  test("an incremental coordinate is shown where it leads", () => {
    const rows = [row("e1", { x: "17.43", z: "0" }), row("e2", { x: "6.6", incrementalX: true, z: "-4.25" })];
    expect(shown(rows, 1)).toMatchObject({ x: "24.03", z: "-4.25" });
  });

  test("centres, polar elements and arcs have their own", () => {
    const rows = [
      row("e1", { x: "20", z: "0" }),
      row("e2", { kind: "CC", x: "20", z: "-30.5" }),
      row("e3", { kind: "LP", words: { PR: "11.75", IPA: "7.5" } }),
      row("e4", { kind: "CR", x: "52.8", z: "-41", r: "19.3" }),
    ];
    expect(shown(rows, 1)).toEqual({ x: "20", z: "-30.5" });
    expect(shown(rows, 2)).toEqual({ PR: "11.75", PA: "7.5" });
    expect(shown(rows, 3)).toMatchObject({ r: "19.3" });
    expect(dimensionsOf(rows, readRows(rows), 9)).toEqual([]);
  });
});

describe("typing a dimension", () => {
  test("a diameter goes to its own field, sums are worked out, what cannot be read is kept", () => {
    expect(typed(shaft, 3, "x", "40+1,5/2")[3]).toMatchObject({ x: "40.75", z: "" });
    expect(typed(shaft, 3, "x", "4o")[3]?.x).toBe("4o");
    expect(typed(shaft, 3, "x", "41.9")).toBe(shaft);
    expect(typed(shaft, 1, "x", "16.2")[1]).toMatchObject({ x: "16.2", z: "-23.617" });
    expect(typed(shaft, 2, "r", "0,85")[2]?.r).toBe("0,85");
  });

  test("an incremental coordinate keeps counting from the point before; a parameter in it counts from zero", () => {
    const rows = [row("e1", { x: "17.43", z: "0" }), row("e2", { x: "6.6", incrementalX: true, z: "-4.25" })];
    expect(typed(rows, 1, "x", "21,13")[1]).toMatchObject({ x: "3.7", incrementalX: true });
    expect(typed(rows, 1, "x", "QR1")[1]).toMatchObject({ x: "QR1", incrementalX: false });
  });

  test("a length along an axis moves the coordinate and not the other one", () => {
    expect(typed(shaft, 1, "length", "31.04")[1]).toMatchObject({ z: "-31.04", x: "", length: "" });
    expect(typed(shaft, 3, "length", "7.035")[3]).toMatchObject({ x: "31.5", z: "", length: "" });
    const back = [row("e1", { x: "41.9", z: "-3" }), row("e2", { x: "-8.2", incrementalX: true })];
    expect(typed(back, 1, "length", "2.55")[1]).toMatchObject({ x: "-5.1", incrementalX: true });
  });

  test("a sloping line of another length keeps its direction", () => {
    const after = typed(shaft, 4, "length", "40"),
      [from, to] = [endOf(after, 3), endOf(after, 4)];
    expect(after[4]).toMatchObject({ length: "40", x: "", z: "" });
    expect(readRows(after).issues.filter((i) => i.issue.severity === "error")).toEqual([]);
    const before = Math.atan2((58.07 - 41.9) / 2, -51.3 + 23.617);
    expect(Math.atan2(((to?.x ?? 0) - (from?.x ?? 0)) / 2, (to?.z ?? 0) - (from?.z ?? 0))).toBeCloseTo(before, 5);
  });

  test("another angle keeps the coordinate of the longer way", () => {
    const flat = typed(shaft, 4, "angle", "170");
    expect(flat[4]).toMatchObject({ angle: "170", x: "", z: "-51.3" });
    expect(endOf(flat, 4)?.x).toBeCloseTo(41.9 + 2 * 27.683 * Math.tan(Math.PI / 18), 6);
    const steep = typed(shaft, 3, "angle", "100");
    expect(steep[3]).toMatchObject({ angle: "100", x: "41.9", z: "" });
    expect(endOf(steep, 3)?.z).toBeCloseTo(-23.617 - 12.235 * Math.tan(Math.PI / 18), 6);
  });

  test("taking a length away leaves the line where it is", () => {
    const held = typed(shaft, 4, "length", "40"),
      end = endOf(held, 4);
    const rows = [...held.slice(0, 4), row("e5", { length: "40", angle: held[4]?.angle ?? "" })];
    const freed = typed(rows.with(4, row("e5", { angle: "150", length: "12.3" })), 4, "length", "");
    expect(end).not.toBeNull();
    expect(freed[4]).toMatchObject({ length: "", angle: "150" });
    const only = [row("e1", { x: "10", z: "0" }), row("e2", { length: "9.9", x: "10" })];
    expect(typed(only, 1, "length", "")[1]).toMatchObject({ length: "", x: "10" });
  });

  test("polar words: absolute stays absolute, an added angle stays added", () => {
    const rows = [
      row("e1", { x: "20", z: "0" }),
      row("e2", { kind: "CC", x: "20", z: "-30" }),
      row("e3", { kind: "LP", words: { PR: "11.75", IPA: "7.5" } }),
    ];
    expect(typed(rows, 2, "PR", "14.4")[2]?.words).toEqual({ PR: "14.4", IPA: "7.5" });
    expect(typed(rows, 2, "PA", "22.25")[2]?.words).toEqual({ PR: "11.75", IPA: "22.25" });
  });

  test("a typed value comes out as it was typed, whatever the line", () => {
    const size = fc.integer({ min: -40_000, max: -1 }).map((n) => n / 1000),
      wide = fc.integer({ min: 1, max: 90_000 }).map((n) => n / 1000);
    fc.assert(
      fc.property(wide, size, wide, size, wide, (x, z, x2, dz, far) => {
        const rows = [
          row("e1", { x: String(x), z: String(z) }),
          row("e2", { x: String(x2), z: String(Number((z + dz).toFixed(3))) }),
        ];
        const read = readRows(typed(rows, 1, "length", String(far))).rows[1];
        expect(read?.length).toBeCloseTo(far, 6);
      }),
      { numRuns: 60 },
    );
  });
});

test("the constraints of an element", () => {
  const of = (rows: readonly ContourRow[]) => {
    const { rows: read } = readRows(rows);
    return rows.map((r, i) => {
      const one = read[i];
      return one ? holdsOf(r, one) : [];
    });
  };
  expect(of(shaft)).toEqual([[], ["horizontal"], [], ["vertical"], []]);
  expect(of([row("e1", { x: "20", z: "0" }), row("e2", { x: "26.4", angle: "135" })])[1]).toEqual(["sought"]);
  expect(
    of([row("e1", { x: "20", z: "0" }), row("e2", { z: "-5.5" }), row("e3", { kind: "CT", x: "33", z: "-9" })])[2],
  ).toEqual(["tangent"]);
});
