import { expect, test } from "vitest";
import { at } from "../../kernel/geometry/point.ts";
import { chipInSpace } from "./chip.ts";

test("a chip is filled with its area, and its edge runs from place to place of it", () => {
  const ring = [at(0.13, 0), at(0.41, 0.02), at(0.37, 1.9), at(0.09, 1.7)];
  const { positions, index, contact } = chipInSpace({
    rings: [ring],
    contact: [[at(0.13, 0), at(0.09, 1.7)], [at(0.41, 0.02)]],
  });
  let area = 0;
  for (let t = 0; t < index.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => positions.subarray(3 * (index[t + k] ?? 0)));
    if (a && b && c) area += Math.abs((b[0]! - a[0]!) * (c[2]! - a[2]!) - (b[2]! - a[2]!) * (c[0]! - a[0]!)) / 2;
  }
  // Shoelace formula, with the corners above.
  expect(area).toBeCloseTo(0.5056, 4);
  expect(contact.length).toBe(6);
  expect([contact[0], contact[2], contact[3], contact[5]].map((n) => Number(n?.toFixed(4)))).toEqual([
    0, 0.13, 1.7, 0.09,
  ]);
});
