import { describe, expect, test } from "vitest";
import { clampingBodies, jawWidth, type Clamping } from "../../kernel/area/clamping.ts";
import { at } from "../../kernel/geometry/point.ts";
import { chuckParts, JAWS } from "./machine-parts.ts";
import { jawOf } from "./jaw.ts";
import { volumeOf } from "./mesh.ts";

/**
 * The jaws of a chuck that holds a bar, each turned back upright: x, y and z of every corner of bodies and edges, mm.
 */
function jawsOf(diameter: number, size: number, share = 4) {
  const high = diameter / 2,
    left = -3.7 * diameter,
    blank = [[at(left, 0), at(0.4, 0), at(0.4, high), at(left, high)]];
  const clamping: Clamping = { kind: "chuckOutside", diameter, length: diameter, face: left + diameter, size };
  const cut = { left: 2 * left, right: -left, low: 0, high: share * size };
  const jaws = chuckParts({ clamping, bodies: clampingBodies(clamping, blank) }, cut).filter(
    ({ role }) => role === "jaw",
  );
  return jaws.flatMap(({ mesh, edges }, i) => {
    const angle = JAWS[i % 3] ?? 0,
      list = [...mesh.positions, ...edges],
      [c, s] = [Math.cos(angle), Math.sin(angle)];
    return Array.from({ length: list.length / 3 }, (_, k) => {
      const [x = 0, y = 0, z = 0] = list.slice(3 * k, 3 * k + 3);
      return { x: c * x + s * y, y: c * y - s * x, z };
    });
  });
}

describe("the jaws of the chuck", () => {
  test.each([
    [3, 160],
    [20.4, 160],
    [75, 200],
    [230, 315],
  ])("stay in their own third of a turn round a bar of ⌀%f", (diameter, size) => {
    const corners = jawsOf(diameter, size);
    expect(corners.length).toBeGreaterThan(100);
    for (const { x, y } of corners) expect(Math.abs(Math.atan2(y, x))).toBeLessThan((57 * Math.PI) / 180);
  });

  test("have parallel sides where there is room", () => {
    const across = jawsOf(75, 200)
      .filter(({ x }) => x > 40)
      .map(({ y }) => y);
    expect(Math.max(...across) - Math.min(...across)).toBeCloseTo(jawWidth(200), 4);
  });

  test("end at the break line, which bends inwards", () => {
    const high = Math.max(...jawsOf(75, 200, 0.31).map(({ x }) => Math.abs(x)));
    expect(high).toBeLessThanOrEqual(62.001);
    expect(high).toBeGreaterThan(58);
    const ends = jawsOf(75, 200, 0.31).filter(({ x }) => x > 50);
    expect(new Set(ends.map(({ x }) => x.toFixed(2))).size).toBeGreaterThan(5);
  });

  test("with converging sides enclose the right volume", () => {
    // As high as it is long: 3.1 mm at 0.6 over the axis. Twice the half width, over the radius.
    const { mesh } = jawOf([at(-3.1, 0.6), at(0, 0.6), at(0, 3.7), at(-3.1, 3.7)], 2.8);
    expect(volumeOf(mesh)).toBeCloseTo(3.1 * (1.4 * (2 ** 2 - 0.6 ** 2) + 2 * 2.8 * (3.7 - 2)), 2);
    const plate = jawOf([at(-3.1, 6), at(0, 6), at(0, 9.7), at(-3.1, 9.7)], 2.8);
    expect(volumeOf(plate.mesh)).toBeCloseTo(3.1 * 3.7 * 5.6, 3);
  });
});
