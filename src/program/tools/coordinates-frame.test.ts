import { describe, expect, test } from "vitest";
import {
  growthIn,
  isFlipped,
  NO_TRANSFORM,
  settledTransform,
  toProgram,
  toWorkpiece,
  type CoordinateFrame,
  type Transform,
} from "./coordinates-frame.ts";

const frame = (t: Partial<Transform>, shift = { x: 3.17, y: -8.4, z: 0.93 }): CoordinateFrame => ({
  shift,
  transform: { ...NO_TRANSFORM, ...t },
});
const P = { x: 17.31, y: -4.02, z: 6.6 };
const rounded = (p: { readonly x: number | null; readonly y: number | null; readonly z: number | null }) =>
  [p.x, p.y, p.z].map((n) => (n === null ? null : +n.toFixed(9) + 0));
const X = { x: true, y: false, z: false };
const FRAMES: readonly CoordinateFrame[] = [
  frame({}),
  frame({ mirror: X }),
  frame({ rotation: 37.5 }),
  frame({ rotation: -90 }),
  frame({ scale: { x: 0.7, y: 1.3, z: 2 }, centre: { x: 15, y: 20, z: -1 } }),
  frame({ mirror: { x: true, y: true, z: true }, rotation: 211.3, scale: { x: 1.05, y: 1.05, z: 1.05 } }),
];

describe("a frame", () => {
  test.each(FRAMES)("comes back: %j", (f) => {
    expect(rounded(toProgram(f, toWorkpiece(f, P)))).toEqual(rounded(P));
    expect(rounded(toWorkpiece(f, toProgram(f, P)))).toEqual(rounded(P));
  });
  test.each(FRAMES)("leaves an axis unknown that was, and its partner in a turn: %j", (f) => {
    const made = toWorkpiece(f, { ...P, y: null });
    expect([made.x === null, made.y === null, made.z === null]).toEqual([f.transform.rotation !== 0, true, false]);
  });
  test("keeps lengths when it turns and mirrors, and scales them when it scales", () => {
    const long = (f: CoordinateFrame) => {
      const [a, b] = [toWorkpiece(f, P), toWorkpiece(f, { x: 1.1, y: 2.7, z: 6.6 })];
      return Math.hypot((a.x ?? 0) - (b.x ?? 0), (a.y ?? 0) - (b.y ?? 0));
    };
    expect(long(frame({ mirror: X, rotation: 12.4 }))).toBeCloseTo(long(frame({})), 10);
    expect(long(frame({ scale: { x: 1.7, y: 1.7, z: 1 }, rotation: 12.4 }))).toBeCloseTo(1.7 * long(frame({})), 10);
  });
  test("scales, then turns, then mirrors, then shifts", () => {
    const f = frame({ mirror: X, rotation: 90, scale: { x: 2, y: 3, z: 1 } }, { x: 100, y: 10, z: 1 });
    // (1, 2) scaled (2, 6), turned (-6, 2), mirrored (6, 2).
    expect(rounded(toWorkpiece(f, { x: 1, y: 2, z: 0 }))).toEqual([106, 12, 1]);
  });
  test("a centre of scaling stays where it is", () =>
    expect(
      rounded(toWorkpiece(frame({ scale: { x: 0.7, y: 1.3, z: 2 }, centre: P }, { x: 0, y: 0, z: 0 }), P)),
    ).toEqual(rounded(P)));
  test("quarter turns have no remainder", () =>
    expect(toWorkpiece(frame({ rotation: 90 }, { x: 0, y: 0, z: 0 }), P).x).toBe(4.02));
});

test("what changes nothing is none: whole turns, twice a mirror", () => {
  expect(settledTransform({ ...NO_TRANSFORM, rotation: 360 })).toBe(NO_TRANSFORM);
  expect(settledTransform({ ...NO_TRANSFORM, rotation: -720 })).toBe(NO_TRANSFORM);
  expect(settledTransform({ ...NO_TRANSFORM, centre: { x: 4, y: 0, z: 0 } })).toBe(NO_TRANSFORM);
  expect(settledTransform({ ...NO_TRANSFORM, rotation: 365 }).rotation).toBe(5);
  const mirrored = frame({ mirror: X }, { x: 0, y: 0, z: 0 });
  expect(toWorkpiece(mirrored, toWorkpiece(mirrored, P))).toEqual(P);
});

test("one mirrored axis of a plane turns its arcs round, two do not", () => {
  const both = { ...NO_TRANSFORM, mirror: { x: true, y: true, z: false } };
  const one = { ...NO_TRANSFORM, mirror: X };
  expect([isFlipped(one, "XY"), isFlipped(one, "ZX"), isFlipped(one, "YZ")]).toEqual([true, true, false]);
  expect([isFlipped(both, "XY"), isFlipped(both, "ZX")]).toEqual([false, true]);
});

test("circles grow with one factor, and in their own plane only", () => {
  const t = { ...NO_TRANSFORM, scale: { x: 1.4, y: 1.4, z: 0.6 } };
  expect([growthIn(t, "XY"), growthIn(t, "ZX")]).toEqual([1.4, null]);
  expect([growthIn({ ...t, rotation: 5 }, "XY"), growthIn({ ...NO_TRANSFORM, rotation: 5 }, "YZ")]).toEqual([
    1.4,
    null,
  ]);
});
