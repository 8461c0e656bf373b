import { describe, expect, test } from "vitest";
import { at } from "../../kernel/point.ts";
import { chuckParts, JAWS } from "./furniture.ts";
import { jawOf } from "./jaw.ts";
import { volumeOf } from "./mesh.ts";

/** The jaws of the chuck in which a bar is held, each turned back upright: x, y and z of every corner of bodies and edges, mm. */
function jawsOf(diameter: number) {
  const high = diameter / 2, left = -3.7 * diameter;
  const made = chuckParts([[at(left, 0), at(0.4, 0), at(0.4, high), at(left, high)]], [], []) ?? expect.fail("a bar is held");
  const jaws = made.parts.filter(({ role }) => role === "jaw");
  return JAWS.flatMap((angle, i) =>
    jaws.slice(2 * i, 2 * i + 2).flatMap(({ mesh, edges }) => {
      const list = [...mesh.positions, ...edges], [c, s] = [Math.cos(angle), Math.sin(angle)];
      return Array.from({ length: list.length / 3 }, (_, k) => {
        const [x = 0, y = 0, z = 0] = list.slice(3 * k, 3 * k + 3);
        return { x: c * x + s * y, y: c * y - s * x, z };
      });
    })
  );
}

describe("the jaws of the chuck", () => {
  test.each([0.9, 3, 5.5, 7.9, 8.3, 20.4, 75, 305])("stay in their own third of the turn round a bar of ⌀%f", (diameter) => {
    const corners = jawsOf(diameter);
    expect(corners.length).toBeGreaterThan(200);
    for (const { x, y } of corners) expect(Math.abs(Math.atan2(y, x))).toBeLessThan((57 * Math.PI) / 180);
  });

  test.each([[20.4, 8], [75, 15.75], [305, 60]])("have parallel sides where there is room: round ⌀%f they are %f wide",
    (diameter, wide) => {
      const corners = jawsOf(diameter), grips = Math.min(...corners.map(({ x }) => x));
      const across = corners.filter(({ x }) => x < grips + 0.01).map(({ y }) => y);
      expect(Math.max(...across) - Math.min(...across)).toBeCloseTo(wide, 4);
    });

  test("whose sides run together enclose what they should", () => {
    // As high as it is long: 3.1 mm at 0.6 over the axis. Twice the half width, over the radius.
    const { mesh } = jawOf([at(-3.1, 0.6), at(0, 0.6), at(0, 3.7), at(-3.1, 3.7)], 2.8);
    expect(volumeOf(mesh)).toBeCloseTo(3.1 * (1.4 * (2 ** 2 - 0.6 ** 2) + 2 * 2.8 * (3.7 - 2)), 2);
    const plate = jawOf([at(-3.1, 6), at(0, 6), at(0, 9.7), at(-3.1, 9.7)], 2.8);
    expect(volumeOf(plate.mesh)).toBeCloseTo(3.1 * 3.7 * 5.6, 3);
  });
});
