import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import "../../../tests/seed.ts";
import { newRow } from "../../program/job/job.ts";
import { newPart } from "./finished-part.ts";
import { printPart, readPart } from "./part-file.ts";
import { plannedPart } from "./planned-part.ts";

const file = (given: object) => JSON.stringify({ format: "turnwise-part/1", name: "PART", outside: [], ...given });

test.each([
  ["no JSON", "{", ["notJson"]],
  ["a list", "[]", ["notPart"]],
  ["lists within lists", "[".repeat(101) + "]".repeat(101), ["notPart"]],
  ["another format", file({ format: "turnwise-machine/1" }), ["notPart"]],
  ["a newer version", file({ format: "turnwise-part/2" }), ["newer"]],
  ["a file that is too long", file({ name: " ".repeat(200_001) }), ["tooLong"]],
  ["no name", file({ name: undefined }), ["missing name"]],
  ["an unknown member", file({ colour: "red" }), ["unknown colour"]],
  ["an unknown cell", file({ outside: [{ x: 1, y: 2 }] }), ["unknown outside.0.y"]],
  ["a wrong kind", file({ outside: [{ kind: "Q" }] }), ["wrong outside.0.kind"]],
  ["a wrong cell", file({ outside: [{ x: true }] }), ["wrong outside.0.x"]],
  ["a number out of range", file({ outside: [{ x: 1e9 }] }), ["high outside.0.x"]],
  ["a roughness of 0", file({ general: { ra: 0 } }), ["low general.ra"]],
  ["an unknown mark", file({ outside: [{ x: 1 }], marks: { e1: { colour: 1 } } }), ["unknown marks.e1.colour"]],
  ["a mark without its row", file({ marks: { e9: {} } }), ["noRow e9"]],
  ["one id twice", file({ outside: [{ id: "a" }, { id: "a" }] }), ["sameId a"]],
  ["an unknown clamping", file({ clamping: { kind: "glue", words: {} } }), ["wrong clamping.kind"]],
  [
    "an unknown word of a clamping",
    file({ clamping: { kind: "collet", words: { X: 1 } } }),
    ["unknown clamping.words.X"],
  ],
  ["an unknown word of a blank", file({ blank: { outside: 1, colour: 2 } }), ["unknown blank.colour"]],
  ["too many rows", file({ outside: Array.from({ length: 501 }, () => ({})) }), ["high outside"]],
])("%s is named", (_, text, wanted) => {
  const { part, problems } = readPart(text);
  const named = problems.map((p) =>
    p.code === "row" ? p.code : [p.code, ...Object.values(p.values).filter((v) => typeof v === "string")].join(" "),
  );
  expect([part, named]).toEqual([null, wanted]);
});

test("numbers and texts are cells; rows without an id are numbered", () => {
  const { part } = readPart(
    file({
      outside: [
        { x: 20, z: "0" },
        { id: "seat", z: -10.5 },
        { kind: "CHF", r: 1 },
      ],
    }),
  );
  expect(part?.outside).toEqual([
    newRow("e1", { x: "20", z: "0" }),
    newRow("seat", { z: "-10.5" }),
    newRow("e3", { kind: "CHF", r: "1" }),
  ]);
});

describe("anything is read without a fault", () => {
  const part = { ...newPart("P"), outside: [newRow("e1", { x: "20", z: "0" }), newRow("e2", { z: "-30" })] };
  test("damaged files", () => {
    const text = printPart(part);
    fc.assert(
      fc.property(fc.nat(text.length), fc.nat(20), fc.string({ maxLength: 8 }), (from, count, put) => {
        const read = readPart(text.slice(0, from) + put + text.slice(from + count));
        expect(read.part !== null || read.problems.length > 0).toBe(true);
        if (read.part) plannedPart(read.part);
      }),
      { numRuns: 200 },
    );
  });

  test("any data", () => {
    fc.assert(
      fc.property(
        fc.json({ maxDepth: 3 }),
        fc.constantFrom("outside", "inside", "marks", "blank", "clamping", "rules"),
        (data, key) => {
          const read = readPart(`{"format":"turnwise-part/1","name":"P","outside":[],"${key}":${data}}`);
          expect(read.part !== null || read.problems.length > 0).toBe(true);
        },
      ),
      { numRuns: 200 },
    );
  });

  test("any rows are planned without a fault", () => {
    const cell = fc.constantFrom("", "0", "20", "-10", "-30", "1e5", "?", "abc", "-0.5", "20,5");
    const row = fc.record({
      kind: fc.constantFrom("L", "L", "RND", "CHF", "CR", "CC", "C", "CT", "LP", "CP", "CTP", "UDC", "GRV"),
      x: cell,
      z: cell,
      r: cell,
      angle: fc.constantFrom("", "45", "190"),
      form: fc.constantFrom("", "E", "RADIAL"),
      turn: fc.constantFrom("cw", "ccw"),
      tangent: fc.boolean(),
    });
    const mark = fc.record(
      {
        thread: fc.constantFrom("M20", "1/2 NPT", "x"),
        tolerance: fc.constantFrom("h6", "+1/-1", "x"),
        undercut: fc.constantFrom("DIN 76-A", "F", "x"),
      },
      { requiredKeys: [] },
    );
    fc.assert(
      fc.property(
        fc.array(row, { maxLength: 8 }),
        fc.array(row, { maxLength: 5 }),
        fc.array(mark, { maxLength: 8 }),
        fc.boolean(),
        (outside, inside, marks, behind) => {
          const rows = (all: typeof outside, letter: string) =>
            all.map((each, i) => newRow(`${letter}${i + 1}`, each as Parameters<typeof newRow>[1]));
          const made = plannedPart({
            ...newPart("P"),
            outside: rows(outside, "e"),
            inside: rows(inside, "i"),
            marks: Object.fromEntries(marks.map((each, i) => [`e${i + 1}`, each])),
            unmachinedBehind: behind,
          });
          expect(made.part !== null || made.problems.some((p) => p.severity === "error")).toBe(true);
        },
      ),
      { numRuns: 500 },
    );
  });
});
