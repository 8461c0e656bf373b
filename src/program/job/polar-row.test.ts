import { describe, expect, test } from "vitest";
import { catalogue } from "../../cycles/index.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { parse } from "../../nc/parse.ts";
import { programText } from "../../nc/print.ts";
import { LAYOUTS } from "../../nc/style.ts";
import { readRows } from "./contour-rows.ts";
import { exampleJob, newRow, type ContourRow } from "./job.ts";
import { contourStatements } from "./print-contour.ts";
import { printJob } from "./print-job.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const row = (kind: ContourRow["kind"], given: Partial<ContourRow> = {}) => newRow("e", { kind, ...given });
const text = (rows: readonly ContourRow[]) =>
  programText(contourStatements(rows), LAYOUTS.tnc7)
    .trim()
    .split("\n")
    .map((line) => line.trim().replace(/^\d+ /, ""));
const rounded = (rows: readonly ContourRow[]) =>
  readRows(rows).rows.map((r) => r.end && [r.end.x, r.end.z].map((n) => Math.round(n * 1000) / 1000 || 0));
const codes = (rows: readonly ContourRow[]) => readRows(rows).issues.map((i) => [i.row + 1, i.field, i.issue.code]);

const start = row("L", { x: "20", z: "0" });
const pole = row("CC", { x: "20", z: "-30" });

describe("polar rows", () => {
  test("are printed as typed, each with its words", () => {
    expect(
      text([
        start,
        pole,
        row("LP", { words: { PR: "30", PA: "0" } }),
        row("LP", { words: { IPA: "60" } }),
        row("CP", { words: { PA: "180" }, turn: "ccw" }),
        row("CTP", { words: { PR: "30", PA: "30" } }),
        row("LP", { words: { IPR: "-5", PA: "Q7" } }),
        row("LP", { words: { PR: "1,2346", PA: "12.34567" } }),
      ]).slice(2),
    ).toEqual([
      "LP PR+30 PA+0",
      "LP IPA+60",
      "CP PA+180 DR+",
      "CTP PR+30 PA+30",
      "LP IPR-5 PA+Q7",
      "LP PR+1.235 PA+12.3457",
    ]);
  });

  test("end round the pole: PR is a true length, PA counts from +Z towards +X", () => {
    expect(
      rounded([
        start,
        pole,
        row("LP", { words: { PR: "10", PA: "90" } }),
        row("LP", { words: { IPA: "90" } }),
        row("LP", { words: { IPR: "5" } }),
      ]),
    ).toEqual([[20, 0], null, [40, -30], [20, -40], [20, -45]]);
  });

  test("an arc round the pole keeps its distance, and coordinates go on from its end", () => {
    const { contour, issues, rows } = readRows([
      start,
      pole,
      row("CP", { words: { PA: "90" }, turn: "ccw" }),
      row("L", { z: "-50" }),
    ]);
    expect(issues).toEqual([]);
    expect(contour.segments.map((s) => s.kind)).toEqual(["arc", "line"]);
    expect(rows[3]?.end?.x).toBeCloseTo(80, 9);
  });

  test("a tangential arc is a tangential arc", () => {
    const { contour, issues } = readRows([
      start,
      pole,
      row("LP", { words: { PR: "20", PA: "0" } }),
      row("CTP", { words: { PR: "20", PA: "90" } }),
    ]);
    expect(issues).toEqual([]);
    expect(contour.segments.map((s) => s.kind)).toEqual(["line", "arc"]);
    expect(contour.segments[1]?.to.r).toBeCloseTo(30, 9);
  });

  test("corners are broken between polar elements", () => {
    const { contour, issues } = readRows([
      start,
      pole,
      row("LP", { words: { PR: "20", PA: "0" } }),
      row("RND", { r: "2" }),
      row("LP", { words: { PA: "60" } }),
    ]);
    expect(issues).toEqual([]);
    expect(contour.segments.map((s) => s.kind)).toEqual(["line", "arc", "line"]);
  });

  test("say what is missing: the pole, a point to go on from, a readable number", () => {
    expect(codes([start, row("LP", { words: { PR: "10", PA: "90" } })])).toEqual([[2, null, "poleMissing"]]);
    expect(codes([start, pole, row("LP")])).toEqual([[3, null, "contourPoint"]]);
    expect(codes([pole, row("LP", { words: { PR: "30", IPA: "5" } }), start])).toContainEqual([2, "PA", "missing"]);
    expect(codes([start, pole, row("LP", { words: { PR: "abc", PA: "0" } }), row("L", { z: "-20" })])).toEqual([
      [3, "PR", "notANumber"],
    ]);
  });

  test("may be the start point", () => {
    expect(rounded([pole, row("LP", { words: { PR: "30", PA: "0" } }), row("L", { z: "-20" })])).toEqual([
      null,
      [20, 0],
      [20, -20],
    ]);
  });
});

test("the table and the run of its program make the same contour", () => {
  const cycle = catalogue.find((c) => c.contour === "free" && c.evidence === "A");
  if (!cycle) throw new Error("no cycle with a free contour");
  const contour = [
    row("L", { x: "20", z: "0" }),
    row("L", { z: "-10" }),
    row("CC", { x: "20", z: "-30" }),
    row("LP", { words: { PR: "20", PA: "60" } }),
    row("RND", { r: "1" }),
    row("CP", { words: { IPA: "40" }, turn: "ccw" }),
    row("CTP", { words: { PR: "30", PA: "125" } }),
    row("L", { z: "-60" }),
  ];
  const text = printJob({ ...exampleJob(cycle), contour }, ncLabels("en"));
  const ran = run(parse(text), { tools: shippedTools, rapid: 10_000 }).operations[0]?.plan.contour.map((s) => [
    s.kind,
    s.to.z,
    s.to.r,
  ]);
  const read = readRows(contour);
  expect(read.issues).toEqual([]);
  expect(ran).toEqual(read.contour.segments.map((s) => [s.kind, expect.closeTo(s.to.z, 6), expect.closeTo(s.to.r, 6)]));
});
