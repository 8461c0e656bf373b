import fc from "fast-check";
import { expect, test } from "vitest";
import { boxAround, boxOf, inBox } from "./box.ts";
import { at, type Pt, type Ring } from "../geometry/point.ts";

/** Reference implementation: clips a ring to one side of the box after the other. */
function plainly(ring: Ring, { left, right, low, high }: ReturnType<typeof boxOf>): Ring {
  const sides = [
    ["z", left, 1],
    ["z", right, -1],
    ["r", low, 1],
    ["r", high, -1],
  ] as const;
  return sides.reduce<Ring>(
    (cut, [axis, limit, sign]) =>
      cut.flatMap((b, i) => {
        const a = cut[(i + cut.length - 1) % cut.length] as Pt,
          [from, to] = [(a[axis] - limit) * sign, (b[axis] - limit) * sign];
        const out: Pt[] = [];
        if (from >= 0 !== to >= 0) {
          const t = from / (from - to);
          out.push(at(axis === "z" ? limit : a.z + (b.z - a.z) * t, axis === "r" ? limit : a.r + (b.r - a.r) * t));
        }
        return to >= 0 ? [...out, b] : out;
      }),
    ring,
  );
}

const coordinate = fc.integer({ min: -5000, max: 5000 }).map((n) => n / 97);
const wild = fc
  .array(fc.record({ z: coordinate, r: coordinate }), { minLength: 3, maxLength: 200 })
  .map((all) => all.map(({ z, r }) => at(z, r)));
/** A long outline of small steps, like a stock: most of it lies outside any box. */
const stairs = fc
  .tuple(fc.integer({ min: 40, max: 300 }), coordinate)
  .map(([count, from]): Ring => [
    ...Array.from({ length: count }, (_, i) => at(from + 0.137 * (i >> 1), 0.093 * ((i + 1) >> 1))),
    at(from + 0.07 * count, -3.3),
  ]);

test("the area in a box equals the ring clipped to each side in turn, to the last bit", () => {
  let cut = 0;
  fc.assert(
    fc.property(fc.oneof(wild, stairs), coordinate, coordinate, coordinate, coordinate, (ring, z0, r0, z1, r1) => {
      const box = boxAround([[at(z0, r0), at(z1, r1)]]),
        own = boxOf(ring);
      const isBeside = own.left >= box.right || own.right <= box.left || own.low >= box.high || own.high <= box.low;
      const plain = isBeside ? [] : plainly(ring, box),
        [found = []] = inBox([ring], box);
      if (plain.length > 2 && ring.length > 40) cut += 1;
      expect(found).toEqual(plain.length > 2 ? plain : []);
    }),
    { numRuns: 1500 },
  );
  expect(cut).toBeGreaterThan(100);
});
