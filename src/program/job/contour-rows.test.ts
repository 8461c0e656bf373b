import { expect, test } from "vitest";
import { readRows } from "./contour-rows.ts";
import { newRow, type ContourRow } from "./job.ts";
import { contourStatements } from "./print-contour.ts";

const row = (kind: ContourRow["kind"], given: Partial<ContourRow> = {}): ContourRow => newRow("e", { kind, ...given });
const codes = (rows: readonly ContourRow[]) => readRows(rows).issues.map((i) => [i.row + 1, i.field, i.issue.code]);

const printed = [
  row("L", { x: "75", z: "-20" }),
  row("L", { x: "50" }),
  row("RND", { r: "2" }),
  row("L", { x: "20", z: "-25" }),
  row("RND", { r: "2" }),
  row("L", { z: "0" }),
];

test("reads the printed contour: three lines and two arcs, each from its row", () => {
  const { contour, rowOfSegment, issues } = readRows(printed);
  expect(issues).toEqual([]);
  expect(contour.segments.map((s) => s.kind)).toEqual(["line", "arc", "line", "arc", "line"]);
  expect(rowOfSegment).toEqual([1, 2, 3, 4, 5]);
});

test("a coordinate left out stays as it was, an incremental one adds to it", () => {
  const { rows } = readRows([
    row("L", { x: "75", z: "-20" }),
    row("L", { x: "50" }),
    row("L", { x: "-10", z: "-5", incrementalX: true, incrementalZ: true }),
  ]);
  expect(rows.map((r) => r.end)).toEqual([
    { x: 75, z: -20 },
    { x: 50, z: -20 },
    { x: 40, z: -25 },
  ]);
  expect(rows[1]?.inherited).toEqual({ x: 75, z: -20 });
});

test("a sum and a decimal comma are read", () => {
  expect(readRows([row("L", { x: "75/2+1", z: "-2,5" })]).rows[0]?.end).toEqual({ x: 38.5, z: -2.5 });
});

test("the start point needs both coordinates", () => {
  expect(codes([row("L", { x: "75" }), row("L", { x: "50", z: "0" })])).toContainEqual([1, "z", "missing"]);
});

test("text that is no number is reported at its field, and the rest is still drawn", () => {
  const rows = [printed[0] ?? row("L"), row("L", { x: "abc", z: "-30" }), row("L", { x: "20" })];
  expect(codes(rows)).toEqual([[2, "x", "notANumber"]]);
  expect(readRows(rows).contour.segments).toHaveLength(2);
});

test("a row in which nothing is typed is not wrong, and has no block", () => {
  const begun = printed.slice(0, 2);
  for (const kind of ["L", "CR", "CT"] as const) {
    const rows = [...begun, row(kind)];
    expect(readRows(rows).issues.filter((found) => found.row === 2 && found.issue.severity !== "info")).toEqual([]);
    expect(contourStatements(rows)).toEqual(contourStatements(begun));
  }
});

test("an element without motion, a lone corner and a corner too long are reported at their row", () => {
  expect(codes([...printed.slice(0, 2), row("CR", { r: "5" })])).toContainEqual([3, null, "contourPoint"]);
  expect(codes([row("RND", { r: "2" }), ...printed.slice(0, 2)])).toContainEqual([1, null, "cornerElementAlone"]);
  expect(codes([...printed.slice(0, 2), row("RND", { r: "200" }), ...printed.slice(3)])).toContainEqual([
    3,
    "r",
    "cornerElementTooLong",
  ]);
});

test("an arc needs its radius, and one that reaches its end", () => {
  const start = row("L", { x: "40", z: "0" });
  expect(codes([start, row("CR", { x: "60", z: "-10" })])).toContainEqual([2, "r", "missing"]);
  expect(codes([start, row("CR", { x: "60", z: "-10", r: "3" })])).toContainEqual([2, "r", "arcTooSmall"]);
  expect(codes([start, row("CR", { x: "60", z: "-10", r: "10", turn: "ccw" })])).toEqual([]);
});

test("a single point is too short, and that belongs to no row", () => {
  expect(codes([printed[0] ?? row("L")])).toEqual([]);
  expect(readRows([]).contour.issues.map((i) => i.code)).toEqual(["contourTooShort"]);
});

test("with an angle an empty coordinate is solved, not inherited; both show the result", () => {
  const { rows, issues } = readRows([row("L", { x: "40", z: "0" }), row("L", { x: "60", angle: "135" })]);
  expect(issues).toEqual([]);
  expect(rows[1]).toMatchObject({ end: { x: 60 }, solvedAxes: { x: false, z: true }, angle: 135, missingValues: 0 });
  expect(rows[1]?.end?.z).toBeCloseTo(-10, 9);
  expect(rows[1]?.length).toBeCloseTo(Math.SQRT2 * 10, 9);
});

test("a question mark solves a coordinate; open values are counted and reported", () => {
  const rows = [row("L", { x: "40", z: "0" }), row("L", { x: "60", z: "?" }), row("L", { x: "60", z: "-30" })];
  expect(readRows(rows).rows.map((r) => r.missingValues)).toEqual([0, 1, 0]);
  expect(codes(rows)).toEqual([[2, null, "elementFree"]]);
  expect(readRows([...rows.slice(0, 2), row("L", { x: "60", z: "-30", length: "20" })]).rows[1]?.end).toEqual({
    x: 60,
    z: -10,
  });
});

test("a corner is rounded between solved points", () => {
  const { contour, issues } = readRows([
    row("L", { x: "20", z: "0" }),
    row("L", { angle: "180" }),
    row("RND", { r: "2" }),
    row("L", { x: "60", z: "-30", angle: "90" }),
  ]);
  expect(issues).toEqual([]);
  expect(contour.segments.map((s) => s.kind)).toEqual(["line", "arc", "line"]);
});

test("an arc about a centre, and one that leaves its line tangentially", () => {
  const { contour, issues, rowOfSegment } = readRows([
    row("L", { x: "20", z: "0" }),
    row("L", { z: "-20" }),
    row("CC", { x: "30", z: "-20" }),
    row("C", { x: "30", z: "-25" }),
    row("L", { x: "50" }),
    row("CT", { x: "60", z: "-30" }),
  ]);
  expect(issues).toEqual([]);
  expect(contour.segments.map((s) => s.kind)).toEqual(["line", "arc", "line", "arc"]);
  expect(rowOfSegment).toEqual([1, 3, 4, 5]);
});

test("faults are reported at their row, also after rows without an element", () => {
  const start = [row("L", { x: "20", z: "0" }), row("CC", { x: "30", z: "-20" })];
  expect(codes([...start, row("C", { x: "30", z: "-25" })])).toEqual([[3, null, "arcOffCircle"]]);
  expect(codes([row("L", { x: "20", z: "0" }), row("C", { x: "30", z: "-25" })])).toContainEqual([
    2,
    null,
    "centreMissing",
  ]);
  expect(
    readRows([...start, row("L", { z: "-20" }), row("L", { x: "40" }), row("L", { x: "10", z: "-5" })]).issues[0],
  ).toMatchObject({
    row: 4,
    issue: { code: "contourCrossesItself", data: { element: 5, other: 3 } },
  });
});

test("a contradicting value is reported at its field", () => {
  expect(codes([row("L", { x: "40", z: "0" }), row("L", { x: "60", z: "-10", angle: "130" })])).toEqual([
    [2, "angle", "elementContradicts"],
  ]);
  expect(codes([row("L", { x: "40", z: "0" }), row("L", { x: "60", length: "-1" })])).toContainEqual([
    2,
    "length",
    "outOfRange",
  ]);
});

test("the printed undercut stands in the corner between its cylinder and its face", () => {
  const rows = [
    row("L", { x: "40", z: "0" }),
    row("L", { z: "-30" }),
    row("UDC", { form: "E", words: { R: "1", DEPTH: "2", BREADTH: "15" } }),
    row("L", { x: "60" }),
  ];
  const { contour, issues, rowOfSegment } = readRows(rows);
  expect(issues).toMatchObject([{ row: 2, issue: { code: "undercutDefaults", severity: "info" } }]);
  expect(Math.min(...contour.segments.map((s) => s.to.r))).toBeCloseTo(18, 6);
  expect(rowOfSegment).toContain(2);
  expect(
    codes([...rows.slice(0, 2), row("UDC", { form: "E", words: { R: "abc" } }), row("L", { x: "60" })]),
  ).toContainEqual([3, null, "notANumber"]);
});

test("a recess in a cylinder", () => {
  const { contour, issues } = readRows([
    row("L", { x: "40", z: "0" }),
    row("L", { z: "-40" }),
    row("GRV", { form: "RADIAL", words: { CENTER: "-20", BREADTH: "6", DIAM: "30" } }),
    row("L", { x: "60" }),
  ]);
  expect(issues).toEqual([]);
  expect(Math.min(...contour.segments.map((s) => s.to.r))).toBeCloseTo(15, 6);
});
