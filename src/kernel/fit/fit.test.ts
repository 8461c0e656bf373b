import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { deviationsOf } from "./fit.ts";
import { standardTolerance, TOLERANCE_RANGES } from "./standard-tolerance.ts";
import { readToleratedSize, readTolerance, toleranceMiddle } from "./typed-tolerance.ts";

/** Limit deviations as tables of the trade print them, µm (decision 0056): size and class, upper, lower. */
const PRINTED = `
40 h6 0 -16
25 H7 21 0
30 k6 15 2
50 g6 -9 -25
20 f7 -20 -41
60 p6 51 32
3 g6 -2 -8
6 f7 -10 -22
10 k6 10 1
18 n6 23 12
30 s6 48 35
50 s6 59 43
65 s6 72 53
100 s6 93 71
120 n6 45 23
80 js6 9.5 -9.5
14 js7 9 -9
3 j6 4 -2
50 j6 11 -5
80 j5 6 -7
24 t6 none
30 t6 54 41
160 r6 90 65
315 r6 130 98
180 u6 235 210
65 x8 168 122
18 x8 72 45
400 a12 -1350 -1920
160 a12 -520 -920
65 d6 -100 -119
250 e6 -100 -129
355 e13 -125 -1015
80 h9 0 -74
500 h11 0 -400
180 c11 -230 -480
30 K7 6 -15
30 M7 0 -21
30 N7 -7 -28
30 R7 -20 -41
50 K6 3 -13
50 M8 5 -34
50 N8 -3 -42
65 R7 -30 -60
80 R7 -32 -62
200 R7 -60 -106
250 J6 22 -7
180 J7 26 -14
14 J8 15 -12
3 K6 0 -6
3 N9 -4 -29
40 N9 0 -62
40 P9 -26 -88
40 K9 none
300 M6 -9 -41
120 E8 126 72
300 f9 -56 -186
315 R10 -98 -308
340 A13 2090 1200
10 D10 98 40
0.5 b11 none
520 h6 none
40 h15 none
40 h4 none
40 q6 none
0 h6 none
`;

test.each(
  PRINTED.trim()
    .split("\n")
    .map((line) => line.split(" ")),
)("%s %s: %s / %s µm", (size = "", cls = "", upper = "", lower = "") => {
  const [, letters = "", grade = ""] = /^([A-Za-z]+)(\d+)$/.exec(cls) ?? [];
  const found = deviationsOf(letters, Number(grade), Number(size));
  expect(found && { upper: found.upper * 1000, lower: found.lower * 1000 }).toEqual(
    upper === "none" ? null : { upper: expect.closeTo(Number(upper), 6), lower: expect.closeTo(Number(lower), 6) },
  );
});

test("grades and sizes grow", () => {
  for (const size of TOLERANCE_RANGES)
    for (let grade = 5; grade < 14; grade++)
      expect(standardTolerance(grade + 1, size)).toBeGreaterThan(standardTolerance(grade, size) ?? NaN);
  expect(standardTolerance(7, 18)).toBe(0.018);
  expect(standardTolerance(7, 18.01)).toBe(0.021);
});

describe("typed tolerances", () => {
  test.each([
    ["h6", 40, 0, -0.016],
    ["H7", 25, 0.021, 0],
    ["js9", 10, 0.018, -0.018],
    ["JS 9", 10, 0.018, -0.018],
    ["k 6", 30, 0.015, 0.002],
    ["+0.02/-0.01", 30, 0.02, -0.01],
    ["+0,02 / −0,01", 30, 0.02, -0.01],
    ["+0.02 -0.01", 30, 0.02, -0.01],
    ["+0.03/+0.01", 30, 0.03, 0.01],
    ["-0.1/-0.3", 30, -0.1, -0.3],
    ["0/-0.2", 30, 0, -0.2],
    ["+0.1/0", 30, 0.1, 0],
    ["+0.1", 30, 0.1, 0],
    ["-0.2", 30, 0, -0.2],
    ["±0.05", 30, 0.05, -0.05],
    ["+/-0.05", 30, 0.05, -0.05],
    ["＋0．1", 30, 0.1, 0],
    ["ISO 2768-m", 30, 0, 0],
    ["2768-mK", 30, 0, 0],
    ["DIN ISO 2768-1-f", 30, 0, 0],
  ])("%s of %f", (text, size, upper, lower) => {
    expect(readTolerance(text, size)).toEqual({ upper, lower });
  });

  test.each(["", "h", "6h", "h6x", "+0.01/+0.02", "0.1", "±", "1e3", "h99", "H7/g6", "hH7", "ISO 2768"])(
    "%j is none",
    (text) => expect(readTolerance(text, 30)).toBeNull(),
  );

  test.each([
    ["40 h6", 40, 39.992],
    ["⌀25H7", 25, 25.011],
    ["Ø 30 k6", 30, 30.009],
    ["30 +0.02/-0.01", 30, 30.005],
    ["30 0/-0.2", 30, 29.9],
    ["30 -0,1/-0,3", 30, 29.8],
    ["12±0.1", 12, 12],
    ["12,5 ±0,1", 12.5, 12.5],
    ["50 mm g6", 50, 49.983],
    ["20 ISO 2768-m", 20, 20],
  ])("%s is made to %f and %f", (text, nominal, middle) => {
    expect(readToleratedSize(text)).toMatchObject({ nominal, middle });
  });

  test.each(["40", "40-0.2", "40+2", "40 - 0.2", "40 +0.02 -0.01", "2*20", "Q5 h6", "h6", "40 h6 h6", "40 mm", ""])(
    "%j is no size",
    (text) => expect(readToleratedSize(text)).toBeNull(),
  );

  test("a negative size, a length along Z, keeps its sign", () =>
    expect(toleranceMiddle("-0.2", -35)?.middle).toBe(-35.1));

  test("whatever is typed is read or refused, and the middle lies within the limits", () => {
    const piece = fc.constantFrom("h", "H", "js", "6", "40", "+", "-", "±", "/", " ", ".", ",", "0", "2768", "m", "ø");
    const typed = fc.oneof(
      fc.string({ maxLength: 80 }),
      fc.array(piece, { maxLength: 9 }).map((list) => list.join("")),
    );
    fc.assert(
      fc.property(typed, fc.double({ min: 0.1, max: 500, noNaN: true }), (text, size) => {
        const read = toleranceMiddle(text, size);
        if (!read) return;
        expect(read.middle).toBeGreaterThanOrEqual(size + read.lower - 0.001);
        expect(read.middle).toBeLessThanOrEqual(size + read.upper + 0.001);
      }),
      { numRuns: 300 },
    );
  });
});
