import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { cutThread, designationOf, noseOfRoot } from "./named-thread.ts";
import { readThread, THREAD_STANDARDS, threadsNamed } from "./threads.ts";

const read = (name: string) => {
  const thread = readThread(name);
  if (!thread) throw new Error(`no thread ${name}`);
  return thread;
};
const RUNS = { numRuns: 200, seed: 20_261_128 };

describe("names as people write them", () => {
  test.each([
    ["M70x1,5", "M70×1.5 6g"],
    ["m 70 × 1.5 - 6g", "M70×1.5 6g"],
    ["M20", "M20 6g"],
    ["M20x2.5", "M20 6g"],
    ["20x1,5", "M20×1.5 6g"],
    ["M20*1.5 LH", "M20×1.5 6g LH"],
    ["M20x1.5 links", "M20×1.5 6g LH"],
    ["M20-LH", "M20 6g LH"],
    ["M20 左", "M20 6g LH"],
    ["M16x1-4h", "M16×1 4h"],
    ["M12-6H/4g6g", "M12 4g6g"],
    ["M16 x Ph3 P1,5", "M16×Ph3 P1.5 6g"],
    ["Ｍ２０×１．５", "M20×1.5 6g"],
    ["М20х1,5", "M20×1.5 6g"],
    ["Gewinde DIN 13 M12", "M12 6g"],
    ["filetage M12", "M12 6g"],
    ["螺纹 M12", "M12 6g"],
    ["M33.5x0.75", "M33.5×0.75 6g"],
    ["G½", "G1/2 A"],
    ['g 1 1/2"', "G1 1/2 A"],
    ["G1-1/4B", "G1 1/4 B"],
    ["1/2 BSP", "G1/2 A"],
    ["BSPP 3/4", "G3/4 A"],
    ["G 1/2 Zoll", "G1/2 A"],
    ["R 3/4", "R3/4"],
    ["Rc1/2", "Rc1/2"],
    ["BSPT 1", "R1"],
    ["NPT 1/2", "1/2-14 NPT"],
    ["1/2-14 npt", "1/2-14 NPT"],
    ["1 1/4 NPT", "1 1/4-11.5 NPT"],
    ["1/4-20 UNC", "1/4-20 UNC 2A"],
    ["1/4 unc", "1/4-20 UNC 2A"],
    ["UNF 3/8", "3/8-24 UNF 2A"],
    ["3/8-24 UNF-3A", "3/8-24 UNF 3A"],
    ["#10-32", "#10-32 UNF 2A"],
    ["No. 10 UNC", "#10-24 UNC 2A"],
    ["10-32", "#10-32 UNF 2A"],
    ["UN 1 1/2-8", "1 1/2-8 UN 2A"],
    ["1½-6 UNC", "1 1/2-6 UNC 2A"],
    ["0.25-20 unc", "1/4-20 UNC 2A"],
    ["W 1/2", "W1/2"],
    ["BSW 3/8", "W3/8"],
    ["1/4 BSF", "BSF 1/4"],
    ["W 1/2-20", "W1/2-20"],
    ["Tr 20 x 4", "Tr20×4 7e"],
    ["tr40*7 LH", "Tr40×7 LH"],
    ["Tr40x14P7", "Tr40×14 P7"],
    ["TR 40 x 14 (P7)", "Tr40×14 P7"],
    ["Tr40", "Tr40×7"],
    ["S 48x8", "S48×8"],
    ["Rd 40", "Rd40×1/6"],
    ["rd40x1/6", "Rd40×1/6"],
  ])("%s is %s", (typed, name) => {
    expect(designationOf(read(typed), "outside")).toBe(name);
  });

  test.each([
    "",
    " ",
    "M",
    "M0x1",
    "M2x1.5",
    "M77x",
    "M77x0",
    "M40",
    "M20x1.5-9z",
    "M20-6A",
    "W7",
    "Tr5000x4",
    "Tr40x10P7",
    "1/4-200",
    "1/0-20",
    "20-",
    "G7",
    "R5/8",
    "1/2-13 NPT",
    "NPTF 1/4",
    "Tr40x7-8c",
    "hello",
    "1/2",
  ])("%s is no thread", (typed) => {
    expect(readThread(typed)).toBeNull();
  });

  test("suggestions begin with the one that is meant", () => {
    const named = (typed: string) => threadsNamed(typed, 6).map(({ name }) => name);
    expect(named("M20")).toEqual(["M20", "M20×2", "M20×1.5", "M20×1"]);
    expect(named("M77x1.5")).toEqual(["M77×1.5"]);
    expect(named("M40")).toEqual(["M40×3", "M40×2", "M40×1.5"]);
    expect(named("Tr4").slice(0, 2)).toEqual(["Tr40×7", "Tr42×7"]);
    expect(named("npt1").slice(0, 2)).toEqual(["1-11.5 NPT", "1/16-27 NPT"]);
    expect(named("unf").length).toBe(6);
    expect(named("")).toEqual([]);
  });

  test("any text is read without an exception, however long it is", () => {
    const pieces = fc.constantFrom(
      "M",
      "Tr",
      "G",
      "R",
      "W",
      "S",
      "Rd",
      "UNC",
      "NPT",
      "x",
      "-",
      "/",
      " ",
      "1",
      "20",
      "½",
      ".",
      ",",
      "6g",
      "LH",
      "(P7)",
      "#",
      "²",
    );
    fc.assert(
      fc.property(
        fc.oneof(
          fc.string({ maxLength: 400 }),
          fc.array(pieces, { maxLength: 40 }).map((all) => all.join("")),
        ),
        (text) => {
          threadsNamed(text, 6);
        },
      ),
      RUNS,
    );
    for (const part of ["1 ", "M20x", "-", "( ", "1/2 ", "iso "]) threadsNamed(part.repeat(20_000), 6);
  });
});

/** SizeLimits of d and d2 (6g), of D1 and D2 (6H), each from the least on. ASME B1.13M as printed by amesweb.info and
 * engineersedge.com, and DIN 13 limits as printed by mdmetric.com; figures on which two of them agree. */
const METRIC: readonly (readonly [
  name: string,
  outside: readonly number[] | null,
  inside: readonly number[] | null,
])[] = [
  ["M1.6", [1.496, 1.581, 1.291, 1.354], [1.221, 1.321, 1.373, 1.458]],
  ["M2", [1.886, 1.981, 1.654, 1.721], null],
  ["M2.5", [2.38, 2.48, 2.117, 2.188], null],
  ["M3", [2.874, 2.98, 2.58, 2.655], null],
  ["M3.5", [3.354, 3.479, 3.004, 3.089], null],
  ["M4", [3.838, 3.978, 3.433, 3.523], null],
  ["M5", [4.826, 4.976, 4.361, 4.456], null],
  ["M6", [5.794, 5.974, 5.212, 5.324], null],
  ["M8", [7.76, 7.972, 7.042, 7.16], null],
  ["M8×1", [7.794, 7.974, 7.212, 7.324], null],
  ["M9×1.25", null, [7.647, 7.912, 8.188, 8.348]],
  ["M10", [9.732, 9.968, 8.862, 8.994], [8.376, 8.676, 9.026, 9.206]],
  ["M10×1.25", [9.76, 9.972, 9.042, 9.16], [8.647, 8.912, 9.188, 9.348]],
  ["M10×1", null, [8.917, 9.153, 9.35, 9.5]],
  ["M10×0.75", [9.838, 9.978, 9.391, 9.491], [9.188, 9.378, 9.513, 9.645]],
  ["M12", null, [10.106, 10.441, 10.863, 11.063]],
  ["M12×1.5", null, [10.376, 10.676, 11.026, 11.216]],
  ["M12×1.25", null, [10.647, 10.912, 11.188, 11.368]],
  ["M12×1", null, [10.917, 11.153, 11.35, 11.51]],
  ["M14", null, [11.835, 12.21, 12.701, 12.913]],
  ["M14×1.5", null, [12.376, 12.676, 13.026, 13.216]],
  ["M16", null, [13.835, 14.21, 14.701, 14.913]],
  ["M16×1.5", null, [14.376, 14.676, 15.026, 15.216]],
  ["M20", null, [17.294, 17.744, 18.376, 18.6]],
  ["M20×2", null, [17.835, 18.21, 18.701, 18.913]],
  ["M20×1.5", null, [18.376, 18.676, 19.026, 19.216]],
  ["M20×1", null, [18.917, 19.153, 19.35, 19.51]],
  ["M24", null, [20.752, 21.252, 22.051, 22.316]],
  ["M24×2", null, [21.835, 22.21, 22.701, 22.925]],
  ["M24×1.5", null, [22.376, 22.676, 23.026, 23.226]],
  ["M64", null, [57.505, 58.305, 60.103, 60.478]],
  ["M64×4", null, [59.67, 60.27, 61.402, 61.717]],
  ["M64×2", null, [61.835, 62.21, 62.701, 62.937]],
  ["M70×6", null, [63.505, 64.305, 66.103, 66.478]],
  ["M70×3", null, [66.752, 67.252, 68.051, 68.331]],
  ["M70×1.5", null, [68.376, 68.676, 69.026, 69.238]],
];

test.each(METRIC)("limits of %s are those of the printed tables", (name, outside, inside) => {
  const { outside: o, inside: i, listed } = read(name);
  expect(listed).toBe(true);
  if (outside) expect([o?.tolerance?.crest, o?.tolerance?.pitch].flat()).toEqual(outside);
  if (inside) expect([i?.tolerance?.crest, i?.tolerance?.pitch].flat()).toEqual(inside);
});

/** In inches: d and d2 (A), as printed by efunda.com and in ASME B1.1 tables. */
const UNIFIED: readonly (readonly [name: string, limits: readonly number[]])[] = [
  ["#0-80 UNF", [0.0563, 0.0595, 0.0496, 0.0514]],
  ["#1-64 UNC", [0.0686, 0.0724, 0.0603, 0.0623]],
  ["#1-64 UNC-3A", [0.0692, 0.073, 0.0614, 0.0629]],
  ["#2-56 UNC", [0.0813, 0.0854, 0.0717, 0.0738]],
  ["#2-64 UNF", [0.0816, 0.0854, 0.0733, 0.0753]],
  ["#3-48 UNC", [0.0938, 0.0983, 0.0825, 0.0848]],
  ["#4-40 UNC", [0.1061, 0.1112, 0.0925, 0.095]],
  ["#6-32 UNC", [0.1312, 0.1372, 0.1141, 0.1169]],
  ["#8-32 UNC", [0.1571, 0.1631, 0.1399, 0.1428]],
  ["#10-24 UNC", [0.1818, 0.189, 0.1586, 0.1619]],
  ["#10-32 UNF", [0.1831, 0.1891, 0.1658, 0.1688]],
  ["1/4-20 UNC", [0.2408, 0.2489, 0.2127, 0.2164]],
  ["1/4-28 UNF", [0.2425, 0.249, 0.2225, 0.2258]],
  ["1/4-20 UNC-2B", [0.196, 0.207, 0.2175, 0.2224]],
];
test.each(UNIFIED)("limits of %s are those of ASME B1.1", (name, limits) => {
  const { outside, inside } = read(name);
  const { tolerance } = (name.endsWith("B") ? inside : outside) ?? {};
  const found = [tolerance?.crest, tolerance?.pitch].flat();
  // To the ten-thousandth of an inch of the tables, in millimetres of three decimals.
  limits.forEach((limit, i) => expect(Math.abs((found[i] ?? 0) / 25.4 - limit)).toBeLessThan(6e-5));
});

/** Crest, pitch and root diameter outside, then the same inside, mm: basic sizes. */
const BASIC: readonly (readonly [name: string, outside: readonly number[], inside: readonly number[] | null])[] = [
  // ISO 724, DIN 13-1: d, d2, d3, and D1.
  ["M6", [6, 5.35, 4.773], [4.917, 5.35, 6]],
  ["M10", [10, 9.026, 8.16], [8.376, 9.026, 10]],
  ["M20", [20, 18.376, 16.933], [17.294, 18.376, 20]],
  ["M64", [64, 60.103, 56.639], [57.505, 60.103, 64]],
  // ISO 228-1 (mdmetric.com, dcldesign.co.uk).
  ["G1/8", [9.728, 9.147, 8.566], [8.566, 9.147, 9.728]],
  ["G1/2", [20.955, 19.793, 18.631], [18.631, 19.793, 20.955]],
  ["G1", [33.249, 31.77, 30.291], null],
  ["G2", [59.614, 58.135, 56.656], null],
  ["G6", [163.83, 162.351, 160.872], null],
  // ISO 7-1, at the gauge plane.
  ["R3/8", [16.662, 15.806, 14.95], null],
  // ASME B1.20.1: pitch diameter E1 (unifiedalloys.com prints 12.487, 19.772, 31.461, 46.287, 58.325).
  ["1/4-18 NPT", [13.616, 12.487, 11.358], null],
  ["1/2-14 NPT", [21.224, 19.772, 18.321], null],
  ["1-11.5 NPT", [33.228, 31.461, 29.694], null],
  ["1 1/2-11.5 NPT", [48.054, 46.287, 44.52], null],
  ["2-11.5 NPT", [60.092, 58.325, 56.558], null],
  // UNF nut sizes after DIN (docs.steelcam.org prints D2 8.837, 11.874, 18.019).
  ["3/8-24 UNF", [9.525, 8.837, 8.265], [8.379, 8.837, 9.525]],
  ["1/2-20 UNF", [12.7, 11.875, 11.188], [11.325, 11.875, 12.7]],
  // ISO 2904, DIN 103 (roymech.org).
  ["Tr8×1.5", [8, 7.25, 6.2], [6.5, 7.25, 8.3]],
  ["Tr10×2", [10, 9, 7.5], [8, 9, 10.5]],
  ["Tr12×3", [12, 10.5, 8.5], [9, 10.5, 12.5]],
  ["Tr42×7", [42, 38.5, 34], [35, 38.5, 43]],
  ["Tr48×8", [48, 44, 39], [40, 44, 49]],
  // DIN 405 (f-m-s.dk prints d2 12.412, 37.883, 101.825).
  ["Rd14", [14, 12.413, 10.825], null],
  ["Rd40", [40, 37.883, 35.767], null],
  ["Rd105", [105, 101.825, 98.65], null],
  // DIN 513 by its formulas (MANUALplus 620 p. 572).
  ["S48×8", [48, 42, 34.116], [36, 42, 48]],
];
test.each(BASIC)("basic sizes of %s", (name, outside, inside) => {
  const thread = read(name);
  for (const [side, printed] of [
    ["outside", outside],
    ["inside", inside],
  ] as const) {
    const found = thread[side];
    if (printed)
      [found?.crest, found?.pitch, found?.root].forEach((d, i) =>
        expect(Math.abs((d ?? 0) - (printed[i] ?? 0))).toBeLessThan(0.0015),
      );
  }
});

/** Inches: pitch and minor diameter of Whitworth threads (trfastenings.com). */
test.each([
  ["W1/4", 0.218, 0.186],
  ["W5/16", 0.2769, 0.2414],
  ["W1/2", 0.4467, 0.3933],
  ["W1", 0.92, 0.84],
  ["W2", 1.8578, 1.7155],
  ["W3/4", 0.686, 0.622],
])("pitch and minor diameter of %s", (name, pitch, minor) => {
  const { outside } = read(name);
  expect(Math.abs((outside?.pitch ?? 0) / 25.4 - pitch)).toBeLessThan(1.1e-4);
  expect(Math.abs((outside?.root ?? 0) / 25.4 - minor)).toBeLessThan(1.1e-4);
});

/** d and d2 of class 7e, from the least on, mm (engineersedge.com). */
test.each([
  ["Tr8×1.5", 7.85, 8, 7.013, 7.183],
  ["Tr10×2", 9.82, 10, 8.739, 8.929],
  ["Tr12×3", 11.764, 12, 10.191, 10.415],
  ["Tr12×2", 11.82, 12, 10.729, 10.929],
  ["Tr16×4", 15.7, 16, 13.64, 13.905],
])("limits of %s 7e", (name, ...limits) => {
  const { tolerance } = read(name).outside ?? {};
  expect([tolerance?.crest, tolerance?.pitch].flat()).toEqual(limits);
});

/** Gauge and useful length of a taper, mm: ISO 7-1 (dcldesign.co.uk), ASME B1.20.1 (unifiedalloys.com, in inches). */
test.each([
  ["R1/8", 4, 6.5],
  ["R1/2", 8.2, 13.2],
  ["R2", 15.9, 23.4],
  ["1/2-14 NPT", 0.32 * 25.4, 0.5337 * 25.4],
  ["1-11.5 NPT", 0.4 * 25.4, 0.6828 * 25.4],
  ["3-8 NPT", 0.766 * 25.4, 1.2 * 25.4],
])("gauge length of %s", (name, length, useful) => {
  const { gauge, taper } = read(name);
  expect([gauge?.length, gauge?.useful]).toEqual([expect.closeTo(length, 2), expect.closeTo(useful, 2)]);
  expect(taper).toBe(1 / 16);
});

test("the middle of a class has crest and pitch diameter in the middle of their limits", () => {
  const { outside, inside } = read("M20×1.5");
  // 19.732 … 19.968; 18.854 … 18.994; the root moves with the flanks.
  expect(cutThread(outside!, "middle")).toEqual({ crest: 19.85, pitch: 18.924, root: 18.058, depth: 0.896 });
  expect(cutThread(outside!, "basic")).toEqual({ crest: 20, pitch: 19.026, root: 18.16, depth: 0.92 });
  expect(cutThread(inside!, "middle")).toEqual({ crest: 18.526, pitch: 19.121, root: 20.095, depth: 0.785 });
});

test.each([
  ["M20×1.5", "outside", 1.5 * 0.14434],
  ["M20×1.5", "inside", 1.5 * 0.10825],
  ["W1/2", "outside", (25.4 / 12) * 0.137329],
  ["1/2-14 NPT", "outside", (25.4 / 14) * 0.033],
  ["Rd40", "outside", (25.4 / 6) * 0.23851],
] as const)("root radius of %s %s as the standard states it", (name, side, radius) => {
  const thread = read(name);
  expect(noseOfRoot(thread, thread[side]!)).toBeCloseTo(radius, 2);
});

test("every name of the tables is read as itself, once", () => {
  const all = THREAD_STANDARDS.flatMap(({ names, id }) => names.map((name) => [id, read(name)] as const));
  expect(all.length).toBeGreaterThan(350);
  for (const [id, { standard, listed }] of all) expect([id, listed]).toEqual([standard, true]);
  expect(new Set(all.map(([, { name, standard }]) => `${standard} ${name}`)).size).toBe(all.length);
});

test("any metric size has core < pitch < major, and g in H never meets", () => {
  fc.assert(
    fc.property(fc.double({ min: 1, max: 600, noNaN: true }), fc.double({ min: 0.2, max: 12, noNaN: true }), (d, p) => {
      const [nominal, pitch] = [Math.round(d * 100) / 100, Math.round(p * 100) / 100];
      const thread = readThread(`M${nominal}x${pitch}`);
      fc.pre(thread !== null);
      const { outside: o, inside: i } = thread!;
      for (const aim of ["basic", "middle"] as const) {
        const [shaft, nut] = [cutThread(o!, aim), cutThread(i!, aim)];
        expect(shaft.root < shaft.pitch && shaft.pitch < shaft.crest).toBe(true);
        expect(nut.crest < nut.pitch && nut.pitch < nut.root).toBe(true);
        // Clearance at crest, flank and root.
        expect(nut.root - shaft.crest).toBeGreaterThanOrEqual(0);
        expect(nut.pitch - shaft.pitch).toBeGreaterThanOrEqual(0);
        expect(nut.crest - shaft.root).toBeGreaterThanOrEqual(0);
      }
      const [T, U] = [o!.tolerance!, i!.tolerance!];
      expect(
        T.crest[0] < T.crest[1] && T.crest[1] <= nominal && T.pitch[1] <= U.pitch[0] && U.crest[0] < U.crest[1],
      ).toBe(true);
    }),
    RUNS,
  );
});
