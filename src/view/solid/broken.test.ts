import { describe, expect, test } from "vitest";
import { at } from "../../kernel/geometry/point.ts";
import { brokenOutlines, brokenSolid } from "./broken.ts";
import { volumeOf } from "./mesh.ts";

/** A disc of ⌀160 from Z-90 to Z-30, cut off at ⌀100 and behind Z-70. */
const DISC = [[at(-90, 0), at(-30, 0), at(-30, 80), at(-90, 80)]];
const CUT = { left: -70, right: 40, low: 0, high: 50 };
const corners = (list: Float32Array) =>
  Array.from({ length: list.length / 3 }, (_, i) => {
    const [x = 0, y = 0, z = 0] = list.subarray(3 * i, 3 * i + 3);
    return { r: Math.hypot(x, y), z };
  });
/** The range of a quantity. */
const span = (list: readonly number[]) => [Math.min(...list), Math.max(...list)] as const;

describe("a body of revolution cut off by break lines", () => {
  const { mesh, edges } = brokenSolid(DISC, CUT);

  test("ends at the break lines, which bend inwards all round", () => {
    for (const list of [mesh.positions, edges]) {
      const round = span(corners(list).flatMap(({ r, z }) => (r > 40 && z > -31 ? [r] : [])));
      expect(round[1]).toBeCloseTo(50, 3);
      expect(round[0]).toBeLessThan(49.3);
      expect(round[0]).toBeGreaterThan(48);
      const behind = span(corners(list).flatMap(({ r, z }) => (r > 40 && z < -60 ? [z] : [])));
      expect(behind[0]).toBeCloseTo(-70, 3);
      expect(behind[1]).toBeGreaterThan(-69.3);
      expect(behind[1]).toBeLessThan(-68);
    }
  });

  test("stays closed, and its front plane", () => {
    expect(volumeOf(mesh)).toBeGreaterThan(0.93 * Math.PI * 50 ** 2 * 40);
    expect(volumeOf(mesh)).toBeLessThan(Math.PI * 50 ** 2 * 40);
    expect(span(corners(mesh.positions).map(({ z }) => z))[1]).toBe(-30);
  });

  test("is as it was where nothing cuts it", () => {
    const all = { left: -100, right: 40, low: 0, high: 90 };
    const { r, z } = corners(brokenSolid(DISC, all).mesh.positions).reduce(
      (most, p) => ({ r: Math.max(most.r, p.r), z: Math.min(most.z, p.z) }),
      { r: 0, z: 0 },
    );
    expect(r).toBeCloseTo(80, 4);
    expect(z).toBe(-90);
  });

  test("outside of them there is nothing", () => {
    expect(brokenSolid(DISC, { ...CUT, left: 0 }).mesh.index).toHaveLength(0);
    expect(brokenOutlines(DISC, { ...CUT, left: 0 })).toEqual([]);
  });
});
