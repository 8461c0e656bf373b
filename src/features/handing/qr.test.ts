import { encode } from "uqr";
import * as fc from "fast-check";
import { expect, test } from "vitest";
import { LONGEST_QR, qrOf, qrPath, QUIET } from "./qr.ts";

/** The modules that a path of rectangles covers. */
function drawn(path: string, size: number): boolean[][] {
  const rows = Array.from({ length: size }, () => Array.from({ length: size }, () => false));
  for (const [, x = "", y = "", wide = ""] of path.matchAll(/M(\d+) (\d+)h(\d+)v1h-\d+z/g))
    for (let i = 0; i < Number(wide); i++) (rows[Number(y) - QUIET] ?? [])[Number(x) - QUIET + i] = true;
  return rows;
}

test("the path covers just the black modules of the code", () => {
  fc.assert(
    fc.property(fc.string({ minLength: 1, maxLength: 400 }), (text) => {
      const rows = qrOf(text);
      expect(rows).toEqual(encode(text, { ecc: "L", border: 0 }).data);
      if (rows) expect(drawn(qrPath(rows), rows.length)).toEqual(rows);
    }),
    { numRuns: 30 },
  );
});

test("the longest link that is said to fit does, and the next is said not to", () => {
  expect(qrOf("a".repeat(LONGEST_QR))?.length).toBe(137);
  expect(qrOf("a".repeat(LONGEST_QR + 1))).toBeNull();
  expect(() => encode("a".repeat(LONGEST_QR + 1), { ecc: "L", maxVersion: 30 })).toThrow();
  expect(qrOf("é".repeat(LONGEST_QR / 2 + 1))).toBeNull();
});
