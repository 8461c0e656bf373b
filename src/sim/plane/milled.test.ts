import { describe, expect, test } from "vitest";
import { areaOf } from "../../kernel/area/area.ts";
import { difference, intersection, union } from "../../kernel/area/clip.ts";
import type { MillMotion } from "../../kernel/plane/mill-motion.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import type { MilledBody } from "./body.ts";
import { milledStock, type MilledMoment } from "./milled.ts";

const BLOCK: MilledBody = {
  block: { left: -3.7, right: 81.9, low: 1.3, high: 47.2, bottom: -19.4, top: 0.6 },
  turned: null,
};
const WHOLE = 85.6 * 45.9;
type Spot = readonly [x: number, y: number, z: number | null];
const spot = ([x, y, z]: Spot) => ({ x, y, z });
const feed = (from: Spot, to: Spot, radius = 4.3): MillMotion => ({
  kind: "feed",
  from: spot(from),
  to: spot(to),
  feed: 300,
  radius,
  index: 0,
});
const rapid = (from: Spot, to: Spot, radius = 4.3): MillMotion => ({
  kind: "rapid",
  from: spot(from),
  to: spot(to),
  radius,
  index: 0,
});

function milled(motions: readonly MillMotion[], body: MilledBody = BLOCK) {
  const stock = milledStock({ motions, bodies: [{ step: 0, body }] });
  if (!stock) throw new Error("no body");
  stock.advance(Infinity);
  return stock;
}
/** The area above each limit, less the sweep of the running motion. */
const areas = ({ standing, swept }: MilledMoment) =>
  standing.map((rings, i) => areaOf(difference(rings, swept[i] ?? [])));
const atEnd = (motions: readonly MillMotion[], body?: MilledBody) =>
  areas(milled(motions, body).at({ step: motions.length, fraction: 0 }));
/** Round tools and blanks are polygons, a little smaller than their circles. */
const near = (area: number | false | null | undefined, expected: number) =>
  expect(Math.abs((area || 0) - expected) / expected).toBeLessThan(0.004);
const capsule = (long: number, r: number) => 2 * r * long + Math.PI * r * r;

describe("what a round tool takes of a block", () => {
  test("is a slot with round ends", () => {
    const [above, through] = atEnd([feed([21.7, 23.1, -3.2], [58.4, 30.9, -3.2])]);
    near(WHOLE - (above ?? 0), capsule(Math.hypot(36.7, 7.8), 4.3));
    expect(WHOLE - (above ?? 0)).toBeLessThanOrEqual(capsule(Math.hypot(36.7, 7.8), 4.3));
    expect(through).toBeCloseTo(WHOLE, 6);
  });
  test("is a band along an arc, and a ring where that closes", () => {
    const centre = { x: 40.3, y: 24.6 };
    const arc = (to: Spot): MillMotion => ({
      ...feed([40.3 + 11.7, 24.6, -2.9], to),
      kind: "arc",
      centre,
      turn: "ccw",
    });
    const [quarter] = atEnd([arc([40.3, 24.6 + 11.7, -2.9])]);
    near(WHOLE - (quarter ?? 0), (Math.PI / 2) * 11.7 * 2 * 4.3 + Math.PI * 4.3 ** 2);
    const [round] = atEnd([arc([40.3 + 11.7, 24.6, -2.9])]);
    near(WHOLE - (round ?? 0), 2 * Math.PI * 11.7 * 2 * 4.3);
  });
  test("counts once where passes overlap, and not outside the block or above it", () => {
    const pass = feed([21.7, 23.1, -3.2], [58.4, 23.1, -3.2]);
    const other = feed([58.4, 26.4, -3.2], [21.7, 26.4, -3.2]);
    const [above] = atEnd([pass, other, pass]);
    // Two parallel capsules 3.3 apart: their common part is a bar and two lenses.
    const lens = 2 * 4.3 ** 2 * Math.acos(3.3 / 8.6) - (3.3 / 2) * Math.sqrt(4 * 4.3 ** 2 - 3.3 ** 2);
    const both = 2 * capsule(36.7, 4.3) - (36.7 * (8.6 - 3.3) + lens);
    near(WHOLE - (above ?? 0), both);
    expect(atEnd([feed([-9, 20, -3.2], [-9, 40, -3.2]), feed([10, 20, 0.6], [60, 20, 0.6])])[0]).toBeCloseTo(WHOLE, 6);
  });
  test("is only the part over the block when the path crosses its edge", () => {
    const [above] = atEnd([feed([-30, 24, -1.1], [110, 24, -1.1])]);
    near(WHOLE - (above ?? 0), 85.6 * 8.6);
  });
  test("has a depth: the deepest pass counts, and below the bottom the material is gone", () => {
    const shallow = feed([0, 24, -2.2], [80, 24, -2.2]),
      deep = feed([30.4, 24, -7.7], [49.1, 24, -7.7]);
    const through = feed([40, 24, -19.4], [40, 24, -19.4], 2.1);
    const stock = milled([deep, shallow, through]);
    expect([stock.depths, stock.limits]).toEqual([
      [-2.2, -7.7],
      [0.6, -2.2, -19.4],
    ]);
    const [untouched, first, second] = areas(stock.at({ step: 3, fraction: 0 }));
    // The shallow one runs out over the left side, X-3.7.
    const over = 4.3 ** 2 * Math.acos(3.7 / 4.3) - 3.7 * Math.sqrt(4.3 ** 2 - 3.7 ** 2);
    const right = 4.3 ** 2 * Math.acos(1.9 / 4.3) - 1.9 * Math.sqrt(4.3 ** 2 - 1.9 ** 2);
    near(WHOLE - (untouched ?? 0), capsule(80, 4.3) - over - right);
    near(WHOLE - (first ?? 0), capsule(18.7, 4.3));
    near(WHOLE - (second ?? 0), Math.PI * 2.1 ** 2);
  });
  test("of a ramp is only where the tool end is in the material", () => {
    // It enters half way: from Z4.6 to Z-3.4 the top at Z0.6 is reached after 4 of 8 mm.
    const [above] = atEnd([feed([20, 24, 4.6], [60, 24, -3.4])]);
    near(WHOLE - (above ?? 0), capsule(20, 4.3));
  });
  test("is nothing where height or radius are unknown", () => {
    expect(atEnd([feed([20, 24, null], [60, 24, null]), feed([20, 24, -3], [60, 24, -3], 0)])[0]).toBeCloseTo(WHOLE, 6);
  });
  test("reaches between the ends of an arc in a side plane", () => {
    const dip: MillMotion = {
      ...feed([20, 24, 2.6], [44, 24, 2.6]),
      kind: "arc",
      side: { plane: "ZX", centre: { x: 32, z: 2.6 }, turn: "cw" },
    };
    const [above] = atEnd([dip]);
    // The end is below Z0.6 over twice the root of 12² − 2².
    near(WHOLE - (above ?? 0), capsule(2 * Math.sqrt(140), 4.3));
  });
});

test("at any moment it is the sweep up to then, in whatever order moments are queried", () => {
  const zigzag = Array.from({ length: 130 }, (_, i) =>
    feed([2 + i * 0.55, i % 2 ? 44.1 : 6.3, -1.7 - (i % 3)], [2 + (i + 1) * 0.55, i % 2 ? 6.3 : 44.1, -1.7 - (i % 3)]),
  );
  const stock = milled(zigzag);
  const moments = [130, 7, 88, 0, 41, 40, 129, 12].map((step) => ({ step, fraction: step === 88 ? 0.37 : 0 }));
  const asked = moments.map((m) => areas(stock.at(m)));
  expect(moments.map((m) => areas(milled(zigzag).at(m)))).toEqual(asked);
  for (const [i, { step }] of moments.entries()) {
    const swept = zigzag.slice(0, step).map(({ from, to }) => slot(from.x, from.y, to.x, to.y));
    expect(WHOLE - (asked[i]?.[0] ?? 0)).toBeGreaterThan(areaOf(intersection(union(swept), [side])) * 0.998 - 0.5);
    for (const area of asked[i] ?? []) expect(area).toBeLessThanOrEqual(WHOLE + 1e-6);
  }
});
const side: Ring = [at(-3.7, 1.3), at(81.9, 1.3), at(81.9, 47.2), at(-3.7, 47.2)];
/** A slot without its round ends. */
function slot(x: number, y: number, toX: number, toY: number): Ring {
  const long = Math.hypot(toX - x, toY - y),
    [dx, dy] = [(-(toY - y) / long) * 4.3, ((toX - x) / long) * 4.3];
  return [at(x - dx, y - dy), at(toX - dx, toY - dy), at(toX + dx, toY + dy), at(x + dx, y + dy)];
}

test("is cut in small batches, and shown as far as it is cut", () => {
  const motions = Array.from({ length: 9 }, (_, i) => feed([5, 5 + i * 4.1, -2], [75, 5 + i * 4.1, -2]));
  const stock = milledStock({ motions, bodies: [{ step: 0, body: BLOCK }] });
  expect(stock?.advance(3)).toBe(false);
  const half = stock && areas(stock.at({ step: 9, fraction: 0 }));
  expect(half).toEqual(areas(milled(motions).at({ step: stock?.reached() ?? 0, fraction: 0 })));
  expect(stock?.advance(50)).toBe(true);
  expect(stock && areas(stock.at({ step: 9, fraction: 0 }))).not.toEqual(half);
});

describe("a round body", () => {
  const shaft: readonly Ring[] = [[at(-40, 0), at(0, 0), at(0, 12.4), at(-15.3, 12.4), at(-15.3, 21.7), at(-40, 21.7)]];
  test("stands over a circle; what is above a shoulder is air, and what is milled of the shoulder is told from the rest of it", () => {
    const across = feed([-30, 17.2, -8.1], [30, 17.2, -8.1], 1.6),
      deep = feed([-30, 17.2, -16.9], [30, 17.2, -16.9], 1.6);
    const stock = milled([across, deep, feed([0, 0, -24.6], [0, 0, -24.6], 3.3)], { block: null, turned: shaft });
    expect(stock.limits).toEqual([0, -8.1, -15.3, -16.9, -40]);
    expect([stock.depths, stock.shoulders, stock.hasLower]).toEqual([[-8.1, -16.9, -24.6], [-15.3], false]);
    const at = (step: number) => areas(stock.at({ step, fraction: 0 }));
    const [small, large] = [Math.PI * 12.4 ** 2, Math.PI * 21.7 ** 2],
      hole = Math.PI * 3.3 ** 2;
    const above = (y: number) => 21.7 ** 2 * Math.acos(y / 21.7) - y * Math.sqrt(21.7 ** 2 - y * y),
      flat = above(15.6) - above(18.8);
    for (const [step, expected] of [
      [1, [small, small, large, large, large]],
      [2, [small, small, large - flat, large, large]],
      [3, [small - hole, small - hole, large - flat - hole, large - hole, large]],
    ] as const)
      at(step).forEach((area, i) => near(area, expected[i] ?? 0));
    // From the shoulder down, 1.6 mm of air, then 0.2 mm of material.
    const [, , shoulder] = atEnd(
      [across, feed([-30, 17.2, -15.5], [30, 17.2, -15.5], 1.6), feed([0, 0, -24.6], [0, 0, -24.6], 3.3)],
      {
        block: null,
        turned: shaft,
      },
    );
    near(shoulder, large - flat - hole);
    const came = stock.at({ step: 3, fraction: 0 }).initialBands.map((rings) => areaOf(rings));
    [small, 0, large - small, 0, 0].forEach((area, i) => (area === 0 ? expect(came[i]).toBe(0) : near(came[i], area)));
  });
  test("with a bore is a ring; a turned block is the intersection of both", () => {
    const tube: readonly Ring[] = [[at(-30, 7.6), at(0, 7.6), at(0, 33.8), at(-30, 33.8)]];
    near(atEnd([], { block: null, turned: tube })[0], Math.PI * (33.8 ** 2 - 7.6 ** 2));
    const square = { left: -24.1, right: 24.1, low: -24.1, high: 24.1, bottom: -30, top: 1.4 };
    near(atEnd([], { block: square, turned: tube })[0], squareInCircle(24.1, 33.8) - Math.PI * 7.6 ** 2);
  });
  test("that is turned between two cuts loses the turned area and keeps the milled one", () => {
    const full: readonly Ring[] = [[at(-30, 0), at(0, 0), at(0, 30), at(-30, 30)]],
      thin: readonly Ring[] = [[at(-30, 0), at(0, 0), at(0, 22), at(-30, 22)]];
    const motions = [feed([-40, 0, -3], [40, 0, -3], 5), feed([-40, 40, -3], [40, 40, -3], 5)];
    const stock = milledStock({
      motions,
      bodies: [
        { step: 0, body: { block: null, turned: full } },
        { step: 1, body: { block: null, turned: thin } },
      ],
    });
    stock?.advance(9);
    const slotIn = (r: number) => 2 * (r * r * Math.asin(5 / r) + 5 * Math.sqrt(r * r - 25));
    near(stock && areas(stock.at({ step: 1, fraction: 0 }))[0], Math.PI * 22 ** 2 - slotIn(22));
    near(stock && areas(stock.at({ step: 0, fraction: 1 }))[0], Math.PI * 30 ** 2 - slotIn(30));
  });
  function squareInCircle(half: number, r: number): number {
    const cap = r * r * Math.acos(half / r) - half * Math.sqrt(r * r - half * half);
    return Math.PI * r * r - 4 * cap;
  }
});

describe("a rapid", () => {
  const slotted = feed([10, 24, -4.4], [70, 24, -4.4]);
  test("through material is reported with its place", () => {
    const found = milled([slotted, rapid([70, 24, -4.4], [70, 40, -4.4])]).rapids();
    expect(found.map(({ step }) => step)).toEqual([1]);
    // The bar and its round end, less the end of the slot: a square and a quarter of its circle.
    near(areaOf(found[0]?.rings ?? []), 16 * 8.6 + (Math.PI / 2) * 4.3 ** 2 - 4.3 ** 2 - (Math.PI / 4) * 4.3 ** 2);
  });
  test("in its own slot, above the top, or without a depth is none", () => {
    expect(
      milled([
        slotted,
        rapid([70, 24, -4.4], [10, 24, -4.4]),
        rapid([10, 24, -4.4], [10, 24, 30]),
        rapid([10, 24, 30], [70, 40, 30]),
      ]).rapids(),
    ).toEqual([]);
  });
  test("deeper than the slot it runs in is one", () => {
    const found = milled([slotted, rapid([70, 24, 9], [70, 24, -6.1]), feed([70, 24, -6.1], [70, 24, -6.1])]).rapids();
    expect(found.map(({ step }) => step)).toEqual([1]);
    near(areaOf(found[0]?.rings ?? []), Math.PI * 4.3 ** 2);
  });
});

test("without a body there is nothing to draw", () => {
  expect(milledStock({ motions: [], bodies: [] })).toBeNull();
  expect(milledStock({ motions: [], bodies: [{ step: 0, body: { block: null, turned: [] } }] })).toBeNull();
});

test("of many depths some are shown, all of them depths of the program", () => {
  const steps = Array.from({ length: 17 }, (_, i) => feed([0, 20, -0.7 * (i + 1)], [70, 20, -0.7 * (i + 1)]));
  const { depths } = milled(steps);
  expect(depths).toHaveLength(5);
  expect(depths.at(-1)).toBeCloseTo(-11.9, 9);
  for (const depth of depths) expect(steps.some(({ to }) => to.z === depth)).toBe(true);
});
