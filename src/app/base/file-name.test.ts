import fc from "fast-check";
import { expect, test } from "vitest";
import { fileNameOf, safeFileName } from "./file-name.ts";

test.each([
  ["SHAFT 7.h", "SHAFT 7.h"],
  ["Zoé-李.turnwise-result.json", "Zoé-李.turnwise-result.json"],
  ["../../etc/passwd", "_.._etc_passwd"],
  ["C:\\a\\b.h", "C__a_b.h"],
  [".bashrc", "_.bashrc"],
  ["", "_"],
  ["...", "_"],
  [".h", "_.h"],
  ["con.h", "_con.h"],
  ["AUX", "_AUX"],
  ["lpt1 .part.json", "_lpt1.part.json"],
  ["COM²", "_COM²"],
  ["CONTOUR.h", "CONTOUR.h"],
  ["a\u202Egnp.exe", "a_gnp.exe"],
  ["a\u0000b\r\nc.h", "a_b__c.h"],
  ["<img src=x onerror=alert(1)>.svg", "_img src=x onerror=alert(1)_.svg"],
  [`${"W".repeat(300)}.h`, `${"W".repeat(58)}.h`],
])("%j is saved as %j", (name, file) => expect(safeFileName(name)).toBe(file));

test("any name fits every file system, and a fit name stays", () =>
  fc.assert(
    fc.property(
      fc.oneof(
        fc.string({ unit: fc.integer({ min: 0, max: 0x10ffff }).map((n) => String.fromCodePoint(n)), maxLength: 90 }),
        fc.stringMatching(/^[ .:\\/A-C]{0,9}(?:\.h)?$/),
      ),
      (name) => {
        const file = safeFileName(name);
        expect(file).toMatch(/^(?![. ]).+(?<![. ])$/su);
        expect(file).not.toMatch(/[\\/:*?"<>|\p{Cc}]/u);
        expect(new TextEncoder().encode(file).length).toBeLessThanOrEqual(255);
        expect(safeFileName(file)).toBe(file);
      },
    ),
  ));

test("the name in the first block names the file", () =>
  expect(["BEGIN PGM A/B MM", "L X+1"].map(fileNameOf)).toEqual(["A_B.h", "PROGRAM.h"]));
