import fc from "fast-check";
import { expect, test } from "vitest";
import type { Move } from "../plan/move.ts";
import type { Pt } from "../geometry/point.ts";
import { axisRate, causeOf, cuttingSpeedAt, isAtLimit, secondsOf, speedAt, withinLimit } from "./time.ts";
import { axial, degrees, feed, length, radius } from "../units.ts";

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const purpose = { phase: "rough", run: "rough", step: 1 } as const;
const cut = (to: Pt, f = 0.3, feedUnit: "mm/rev" | "mm/min" = "mm/rev"): Move => ({
  kind: "feed",
  to,
  feed: feed(f),
  feedUnit,
  ...purpose,
});
const constant = { kind: "constant", speed: 550 } as const;
const surface = { kind: "surface", cuttingSpeed: 180, limit: 2500 } as const;

test("a feed per minute needs no spindle", () => {
  expect(secondsOf(at(0, 10), cut(at(-50, 10), 100, "mm/min"), surface, 1000)).toBeCloseTo(30, 12);
});
test("a feed per revolution follows the speed", () => {
  expect(secondsOf(at(0, 10), cut(at(-55, 10)), constant, 1000)).toBeCloseTo((55 / (0.3 * 550)) * 60, 12);
});
test("rapid moves go at the rapid rate", () => {
  expect(secondsOf(at(0, 0), { kind: "rapid", to: at(30, 40), ...purpose }, surface, 6000)).toBeCloseTo(0.5, 12);
});
test("a dwell counts spindle revolutions at the tool position, whatever the feed", () => {
  const still = { ...cut(at(-5, 20), 0, "mm/min"), dwell: 3 };
  expect(secondsOf(at(-5, 20), still, constant, 1)).toBeCloseTo((3 / 550) * 60, 12);
  expect(secondsOf(at(-5, 20), still, surface, 1)).toBeCloseTo((3 * 60 * Math.PI * 40) / (1000 * 180), 12);
});
test("the speed follows the diameter up to its limit", () => {
  expect(speedAt(surface, 30)).toBeCloseTo((1000 * 180) / (Math.PI * 60), 9);
  expect(speedAt(surface, 1)).toBe(2500);
});
test("facing at constant cutting speed is integrated exactly", () => {
  const knee = (1000 * 180) / (2 * Math.PI * 2500);
  const outer = (Math.PI * (37.5 ** 2 - knee ** 2)) / (1000 * 180 * 0.3);
  expect(secondsOf(at(0, 37.5), cut(at(0, 0)), surface, 1)).toBeCloseTo(60 * (outer + knee / (0.3 * 2500)), 9);
});
test("a thread runs at the speed of its start", () => {
  expect(
    secondsOf(
      at(2, 20),
      { kind: "thread", to: at(-28, 20), pitch: length(1.5), axis: "z", angle: degrees(0), stops: true, ...purpose },
      constant,
      1,
    ),
  ).toBeCloseTo((20 / 550) * 60, 9);
});
test("arcs agree with many short lines", () => {
  const arc: Move = {
    kind: "arc",
    to: at(10, 20),
    centre: at(0, 20),
    turn: "cw",
    feed: feed(0.2),
    feedUnit: "mm/rev",
    ...purpose,
  };
  let [sum, last] = [0, at(0, 10)];
  const start = at(0, 10);
  for (let i = 1; i <= 5000; i += 1) {
    const a = -Math.PI / 2 - (i / 5000) * 1.5 * Math.PI;
    const next = at(10 * Math.cos(a), 20 + 10 * Math.sin(a));
    sum += secondsOf(last, cut(next, 0.2), surface, 1);
    last = next;
  }
  expect(secondsOf(start, arc, surface, 1)).toBeCloseTo(sum, 2);
});
test("never NaN, never negative, and additive along a line", () => {
  const any = fc.double({ min: -200, max: 200, noNaN: true });
  fc.assert(
    fc.property(any, any, any, any, fc.double({ min: 0, max: 1, noNaN: true }), (z0, r0, z1, r1, t) => {
      const middle = at(z0 + (z1 - z0) * t, r0 + (r1 - r0) * t);
      const whole = secondsOf(at(z0, r0), cut(at(z1, r1)), surface, 1);
      const parts = secondsOf(at(z0, r0), cut(middle), surface, 1) + secondsOf(middle, cut(at(z1, r1)), surface, 1);
      expect(whole).toBeGreaterThanOrEqual(0);
      expect(parts).toBeCloseTo(whole, 6);
    }),
  );
});
test("no feed and no speed take no time", () => {
  expect(secondsOf(at(0, 0), cut(at(5, 5), 0), constant, 1)).toBe(0);
  expect(secondsOf(at(0, 0), cut(at(5, 5)), { kind: "constant", speed: 0 }, 1)).toBe(0);
  expect(secondsOf(at(0, 0), { kind: "rapid", to: at(5, 5), ...purpose }, constant, 0)).toBe(0);
});

const axes = { x: { rate: 10_000, acceleration: 2 }, z: { rate: 20_000, acceleration: 4 } };

test("rapid axes start and arrive together: the axis slower for its share sets the rate", () => {
  const even = { x: { rate: 6000 }, z: { rate: 12_000 } };
  expect(secondsOf(at(0, 0), { kind: "rapid", to: at(30, 40), ...purpose }, surface, even)).toBeCloseTo(0.4, 12);
  expect(secondsOf(at(0, 0), { kind: "rapid", to: at(100, 40), ...purpose }, surface, even)).toBeCloseTo(0.5, 12);
  expect(secondsOf(at(7, 3), { kind: "rapid", to: at(7, 3), ...purpose }, surface, even)).toBe(0);
});
test("a rapid that is too short for its rate is all ramp; just long enough, both rules agree", () => {
  expect(secondsOf(at(5, 0), { kind: "rapid", to: at(0, 0), ...purpose }, surface, axes)).toBeCloseTo(
    2 * Math.sqrt(5 / 4000),
    12,
  );
  const enough = (20_000 / 60) ** 2 / 4000;
  expect(secondsOf(at(0, 0), { kind: "rapid", to: at(enough, 0), ...purpose }, surface, axes)).toBeCloseTo(
    2 * Math.sqrt(enough / 4000),
    12,
  );
  expect(secondsOf(at(0, 0), { kind: "rapid", to: at(200, 0), ...purpose }, surface, axes)).toBeCloseTo(
    0.6 + 1 / 12,
    12,
  );
});
test("a law of rapids: never sooner than without acceleration, and the same both ways", () => {
  const place = fc.tuple(
    fc.double({ min: -300, max: 300, noNaN: true }),
    fc.double({ min: -300, max: 300, noNaN: true }),
  );
  fc.assert(
    fc.property(place, place, ([z, r], [toZ, toR]) => {
      const rapid = (from: Pt, to: Pt, rates: Parameters<typeof secondsOf>[3]) =>
        secondsOf(from, { kind: "rapid", to, ...purpose }, surface, rates);
      const [a, b] = [at(z, r), at(toZ, toR)];
      const ramped = rapid(a, b, axes);
      expect(ramped).toBeGreaterThanOrEqual(rapid(a, b, { x: { rate: 10_000 }, z: { rate: 20_000 } }));
      expect(rapid(b, a, axes)).toBeCloseTo(ramped, 9);
    }),
  );
});
test("a machine limits a constant speed and a constant cutting speed, and leaves what is slower as it is", () => {
  expect(withinLimit(constant, 500)).toEqual({ kind: "constant", speed: 500 });
  expect(withinLimit(constant, 550)).toBe(constant);
  expect(withinLimit(surface, 1900)).toEqual({ ...surface, limit: 1900 });
  expect(withinLimit({ ...surface, limit: 0 }, 1900)).toEqual({ ...surface, limit: 1900 });
  expect(withinLimit(surface, 2500)).toBe(surface);
});

test("the speed and its limit are the same on both sides of the axis", () => {
  // 180 m/min and 2500 rpm meet at a radius of 11.459 mm.
  for (const r of [0, 3, 11.4, 11.5, 40]) {
    const isLimited = r < 11.459;
    for (const side of [r, -r]) {
      expect([side, isAtLimit(surface, side), speedAt(surface, side) === 2500]).toEqual([side, isLimited, isLimited]);
      expect(speedAt(surface, side)).toBe(speedAt(surface, r));
      expect(cuttingSpeedAt(1000, side)).toBeCloseTo((2 * Math.PI * r * 1000) / 1000, 9);
      if (!isLimited) expect(cuttingSpeedAt(speedAt(surface, side), side)).toBeCloseTo(180, 9);
    }
  }
  expect(isAtLimit({ ...surface, limit: 0 }, 3)).toBe(false);
  expect(isAtLimit(constant, 3)).toBe(false);
  // A face turned through the axis, towards it and away from it; its parts meet at the limit on either side.
  const face = (from: number, to: number) => secondsOf(at(0, from), cut(at(0, to)), surface, 1);
  const half = face(30, 0);
  for (const [from, to] of [
    [30, -30],
    [-30, 30],
  ] as const)
    expect(face(from, to)).toBeCloseTo(2 * half, 9);
  for (const [from, to] of [
    [0, -30],
    [-30, 0],
    [0, 30],
  ] as const)
    expect(face(from, to)).toBeCloseTo(half, 9);
  expect(face(-30, -11)).toBeCloseTo(face(30, 11), 9);
  expect(face(11, -11)).toBeCloseTo((60 * 22) / (0.3 * 2500), 9);
});
test("a feed goes at most as fast as the axis with the larger share of it", () => {
  const rapid = { x: { rate: 3000 }, z: { rate: 9000 } };
  const rates = (
    [
      [10, 4],
      [4, 10],
      [-10, 4],
      [4, -10],
      [7, 7],
    ] as const
  ).map(([z, r]) => axisRate(rapid, at(1, 1), at(1 + z, 1 + r)));
  expect(rates).toEqual([9000, 3000, 9000, 3000, 9000]);
  expect(axisRate(5000, at(0, 0), at(1, 9))).toBe(5000);
});
test("a dwell is no cutting time", () => {
  const still: Move = { ...cut(at(0, 0)), dwell: 2 } as Move;
  expect([causeOf(cut(at(0, 0))), causeOf(still), causeOf({ kind: "rapid", to: at(0, 0), ...purpose })]).toEqual([
    "cutting",
    "dwell",
    "rapid",
  ]);
});
