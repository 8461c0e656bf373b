import fc from "fast-check";
import { expect, test } from "vitest";
import { readRows } from "../../program/job/contour-rows.ts";
import { newRow, type ContourRow } from "../../program/job/job.ts";
import { cornerSized, isCorner, pointAppended, pointInserted, pointMoved } from "./drawing-edits.ts";
import { gridSpacing, onGrid, snapped } from "./snap.ts";

const row = (id: string, given: Partial<ContourRow> = {}) => newRow(id, given);
const rows = [
  row("e1", { x: "75", z: "0" }),
  row("e2", { x: "50" }),
  row("e3", { kind: "RND", r: "2" }),
  row("e4", { z: "-20" }),
];
const moved = (all: readonly ContourRow[], i: number, x: number, z: number) =>
  pointMoved(all, readRows(all), i, { x, z });

test("a dragged point writes typed coordinates; an omitted coordinate is written once the point leaves it", () => {
  expect(moved(rows, 1, 40, 0)[1]).toMatchObject({ x: "40", z: "" });
  expect(moved(rows, 1, 40, -5)[1]).toMatchObject({ x: "40", z: "-5" });
  expect(moved(rows, 1, 50, 0)).toBe(rows);
  const incremental = [rows[0] as ContourRow, row("e2", { x: "-10", incrementalX: true })];
  expect(moved(incremental, 1, 55, 0)[1]).toMatchObject({ x: "-20", incrementalX: true });
});

test("a solved coordinate stays solved when its point is dragged", () => {
  const solved = [row("e1", { x: "40", z: "0" }), row("e2", { x: "60", angle: "135" })];
  const after = moved(solved, 1, 70, -99);
  expect(after[1]).toMatchObject({ x: "70", z: "" });
  expect(readRows(after).rows[1]?.end?.z).toBeCloseTo(-15, 9);
});

test("dividing an element leaves the contour as it was", () => {
  const point = fc.record({ x: fc.integer({ min: 0, max: 200 }), z: fc.integer({ min: -100, max: 0 }) });
  fc.assert(
    fc.property(
      fc.array(point, { minLength: 3, maxLength: 6 }),
      fc.nat(),
      fc.boolean(),
      (points, pick, incremental) => {
        const all = points.map((p, i) =>
          row(
            `e${i + 1}`,
            incremental && i > 0
              ? {
                  x: String(p.x - (points[i - 1]?.x ?? 0)),
                  z: String(p.z - (points[i - 1]?.z ?? 0)),
                  incrementalX: true,
                  incrementalZ: true,
                }
              : { x: String(p.x), z: String(p.z) },
          ),
        );
        const i = 1 + (pick % (all.length - 1)),
          [a, b] = [points[i - 1], points[i]];
        if (!a || !b) return;
        const divided = pointInserted(all, readRows(all), i, { x: (a.x + b.x) / 2, z: (a.z + b.z) / 2 }).rows;
        expect(divided).toHaveLength(all.length + 1);
        expect(
          readRows(divided)
            .rows.map((r) => r.end)
            .toSpliced(i, 1),
        ).toEqual(readRows(all).rows.map((r) => r.end));
      },
    ),
    { numRuns: 100 },
  );
});

test("an arc is divided into two arcs of the same circle", () => {
  const arc = [row("e1", { x: "20", z: "0" }), row("e2", { kind: "CR", x: "40", z: "-10", r: "10", turn: "cw" })];
  const divided = pointInserted(arc, readRows(arc), 1, { x: 20 + 2 * (10 - Math.sqrt(50)), z: -Math.sqrt(50) }).rows;
  const segments = readRows(divided).contour.segments;
  expect(segments.map((s) => s.kind)).toEqual(["arc", "arc"]);
});

test("one gesture inserts a corner element, changes it, limits it and removes it", () => {
  const plain = rows.filter((r) => r.kind === "L");
  const round = cornerSized(plain, 1, "RND", 3).rows;
  expect(round.map((r) => `${r.kind}${r.r}`)).toEqual(["L", "L", "RND3", "L"]);
  expect(cornerSized(round, 1, "CHF", 1.5).rows.map((r) => `${r.kind}${r.r}`)).toEqual(["L", "L", "CHF1.5", "L"]);
  expect(cornerSized(round, 1, "RND", 900).rows[2]?.r).toBe("12.5");
  expect(readRows(cornerSized(round, 1, "RND", 900).rows).issues).toEqual([]);
  expect(cornerSized(round, 1, "RND", 0).rows).toEqual(plain);
  expect([0, 1, 2].map((i) => isCorner(plain, i))).toEqual([false, true, false]);
});

test("points snap to the grid, and to the lines of other points nearby", () => {
  const magnets = { x: [50.3], z: [-20], reach: { x: 1, z: 1 } };
  expect(snapped({ x: 50.2, z: -12.4 }, 1, magnets)).toEqual({ x: 50.3, z: -12 });
  expect(snapped({ x: -3, z: -20.4 }, 5, magnets)).toEqual({ x: 0, z: -20 });
  expect(onGrid(-0.04, 0.1)).toBe(0);
  expect(pointAppended([], { x: 10, z: -0.12345 }).rows[0]).toMatchObject({ x: "10", z: "-0.123" });
  expect(gridSpacing(0.1, 4)).toBe(5);
  expect(gridSpacing(1, 20)).toBe(1);
});
