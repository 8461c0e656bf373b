import { encode } from "uqr";
import * as fc from "fast-check";
import { expect, test } from "vitest";
import { LONGEST_QR, qrOf, qrPath, QUIET } from "./qr.ts";

/** The modules covered by a path of rectangles. */
function drawn(path: string, size: number): boolean[][] {
  const rows = Array.from({ length: size }, () => Array.from({ length: size }, () => false));
  for (const [, x = "", y = "", wide = ""] of path.matchAll(/M(\d+) (\d+)h(\d+)v1h-\d+z/g))
    for (let i = 0; i < Number(wide); i++) (rows[Number(y) - QUIET] ?? [])[Number(x) - QUIET + i] = true;
  return rows;
}

test("the path covers exactly the black modules of the code", () => {
  fc.assert(
    fc.property(fc.string({ minLength: 1, maxLength: 400 }), (text) => {
      const rows = qrOf(text);
      expect(rows).toEqual(encode(text, { ecc: "L", border: 0 }).data);
      if (rows) expect(drawn(qrPath(rows), rows.length)).toEqual(rows);
    }),
    { numRuns: 30 },
  );
});

test("the longest link stated to fit does fit, and one character more does not", () => {
  expect(qrOf("a".repeat(LONGEST_QR))?.length).toBe(137);
  expect(qrOf("a".repeat(LONGEST_QR + 1))).toBeNull();
  expect(() => encode("a".repeat(LONGEST_QR + 1), { ecc: "L", maxVersion: 30 })).toThrow();
  expect(qrOf("é".repeat(LONGEST_QR / 2 + 1))).toBeNull();
});
