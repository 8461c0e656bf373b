import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { parse } from "./parse.ts";
import { issuesOf, print } from "./program.ts";

const samples = import.meta.glob<string>("../../tests/programs/**/*.h", {
  query: "?raw",
  import: "default",
  eager: true,
});
const texts = Object.values(samples);

/** A program text with pieces of it copied, dropped, exchanged or replaced by odd characters. */
const mutated = fc
  .tuple(
    fc.constantFrom(...texts, ""),
    fc.array(
      fc.tuple(
        fc.double({ min: 0, max: 1, noNaN: true }),
        fc.nat(40),
        fc.oneof(
          fc.constantFrom(
            "",
            "~",
            "\r",
            "\n",
            "\r\n",
            ";",
            '"',
            "Q",
            "=",
            "+",
            "/",
            "*",
            " ",
            "\t",
            ",",
            "1e99",
            "9".repeat(400),
            "(",
            "CYCL DEF ",
            "LBL ",
            "\ufeff",
            "中",
            "ß",
          ),
          fc.string({ maxLength: 8 }),
        ),
      ),
      { maxLength: 12 },
    ),
  )
  .map(([text, edits]) =>
    edits.reduce((t, [where, drop, put]) => {
      const at = Math.floor(where * t.length);
      return t.slice(0, at) + put + t.slice(at + drop);
    }, text),
  );

describe("print after parse gives the same text", () => {
  test("any string", () =>
    fc.assert(
      fc.property(fc.string({ unit: "binary" }), (t) => {
        expect(print(parse(t))).toBe(t);
      }),
      { numRuns: 2000 },
    ));
  test("samples with damage", () =>
    fc.assert(
      fc.property(mutated, (t) => {
        const program = parse(t);
        expect(print(program)).toBe(t);
        for (const i of issuesOf(program)) {
          expect(i.line).toBeGreaterThan(0);
          expect(i.column).toBeGreaterThan(0);
          expect(i.offset + i.length).toBeLessThanOrEqual(t.length);
        }
      }),
      { numRuns: 2000 },
    ));
});

const typedNumber = fc
  .tuple(fc.constantFrom("", "+", "-"), fc.constantFrom("0", "7", "12.5", "0,25", "100000", "3.", ".5", "1e5", "00.10"))
  .map((p) => p.join(""));
const lineWord = fc.oneof(
  fc.tuple(fc.constantFrom("X", "Y", "Z", "IX", "IY", "IZ", "C", "x"), typedNumber).map((p) => p.join("")),
  fc.constantFrom(
    "R0",
    "RL",
    "RR",
    "R 0",
    "FMAX",
    "F MAX",
    "FAUTO",
    "F0.2",
    "F0,2",
    "F-1",
    "FQ3",
    "M3",
    "M303",
    "M30",
    "M99999",
    "M3.5",
    "XQ1",
    "X +4",
    "~",
    ";c",
    "FOO",
  ),
);
const spacing = fc.constantFrom(" ", "  ", "\t", "");

test("the one-step reader and the word-by-word reader agree on straight lines", () => {
  fc.assert(
    fc.property(
      fc.constantFrom("L ", "L\t", "L", "LX"),
      fc.array(fc.tuple(lineWord, spacing), { maxLength: 7 }),
      fc.constantFrom("", " ", "\t "),
      (head, words, tail) => {
        const text = `5 ${head}${words.map((w) => w.join("")).join("")}${tail}`;
        const [whole, bare] = [parse(`${text};c`).blocks[0], parse(text).blocks[0]];
        if (text.includes("~") || text.includes(";")) return;
        // A comment bypasses the one-step reader.
        expect(bare?.statement).toEqual(whole?.statement);
        expect(bare?.issues).toEqual(whole?.issues);
      },
    ),
    { numRuns: 3000 },
  );
});
