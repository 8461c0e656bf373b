import { expect, test } from "vitest";
import { programText } from "../../nc/print.ts";
import { LAYOUTS } from "../../nc/style.ts";
import { newRow, type ContourRow } from "./job.ts";
import { contourStatements } from "./print-contour.ts";

const row = (kind: ContourRow["kind"], given: Partial<ContourRow> = {}) => newRow("e", { kind, ...given });
const text = (rows: readonly ContourRow[]) =>
  programText(contourStatements(rows), LAYOUTS.tnc7)
    .trim()
    .split("\n")
    .map((line) => line.trim().replace(/^\d+ /, ""));

test("typed rows are printed as typed, each element in its own words", () => {
  expect(
    text([
      row("L", { x: "20", z: "0" }),
      row("L", { z: "-10", incrementalZ: true }),
      row("CHF", { r: "1" }),
      row("CR", { x: "30", z: "-15", r: "5" }),
      row("CC", { x: "30", z: "-20" }),
      row("C", { x: "40", turn: "ccw" }),
      row("CT", { x: "50", z: "-30" }),
      row("RND", { r: "2" }),
      row("L", { x: "Q5" }),
    ]),
  ).toEqual([
    "L X+20 Z+0",
    "L IZ-10",
    "CHF 1",
    "CR X+30 Z-15 R+5 DR-",
    "CC X+30 Z-20",
    "C X+40 DR+",
    "CT X+50 Z-30",
    "RND R2",
    "L X+Q5",
  ]);
});

test("solved coordinates are printed as numbers, so that the control needs no angle", () => {
  expect(
    text([
      row("L", { x: "40", z: "0" }),
      row("L", { x: "60", angle: "150" }),
      row("L", { angle: "180", length: "10", x: "" }),
    ]),
  ).toEqual(["L X+40 Z+0", "L X+60 Z-17.321", "L X+60 Z-27.321"]);
});

test("the radius of a tangential arc is printed with its turn", () => {
  expect(
    text([
      row("L", { x: "20", z: "0" }),
      row("L", { z: "-20" }),
      row("CR", { x: "30", z: "-25", tangent: true, turn: "ccw" }),
    ])[2],
  ).toBe("CR X+30 Z-25 R+5 DR-");
});

test("an element that is still open has no block", () => {
  expect(text([row("L", { x: "20", z: "0" }), row("L", { angle: "135" }), row("L", { z: "-20" })])).toEqual([
    "L X+20 Z+0",
    "L Z-20",
  ]);
});

test("undercuts and recesses are printed with the words that are typed", () => {
  expect(
    text([
      row("UDC", { form: "E", words: { R: "1", DEPTH: "2", BREADTH: "15", PITCH: "3" } }),
      row("UDC", { form: "THREAD", words: { PITCH: "1.5" } }),
      row("GRV", { form: "AXIAL", words: { CENTER: "30", DEPTH: "2", BREADTH: "4" } }),
    ]),
  ).toEqual(["UDC TYPE_E R1 DEPTH2 BREADTH15", "UDC THREAD PITCH1.5", "GRV AXIAL CENTER30 DEPTH2 BREADTH4"]);
});
