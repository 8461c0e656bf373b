import { expect, test } from "vitest";
import { intervalsBelow } from "./below.ts";
import { upperEnvelope, valueAt, type EnvelopePiece } from "./envelope.ts";

const origin = { feature: "nose", on: "contour", corner: false } as const;
const SIDE = 4;

/** Lines that rise and fall, upper and lower half circles: the pieces of a waved contour. */
const pieces = Array.from({ length: 60 }, (_, i): EnvelopePiece => {
  const u0 = i * SIDE,
    u1 = u0 + SIDE,
    middle = u0 + SIDE / 2,
    height = 10 * Math.sin(i / 5);
  switch (i % 3) {
    case 0:
      return { arc: 0, u0, u1, v0: height, slope: Math.cos(i), origin };
    case 1:
      return { arc: 1, u0, u1, cu: middle, cv: height, radius: 3, origin };
    default:
      return { arc: -1, u0, u1, cu: middle, cv: height, radius: 3, origin };
  }
});

test("intervals below a level contain exactly the places below it, also for pieces that only touch it", () => {
  const envelope = upperEnvelope(pieces),
    left = 1,
    right = 60 * SIDE - 1,
    step = 0.05;
  const wrong: unknown[] = [];
  const touched = pieces.flatMap((p) => (p.arc === 0 ? [] : [p.cv + p.arc * p.radius]));
  for (const level of [-20, -9, -3.21, 0, 0.5, 4.4, 9.7, 12.9, 20, ...touched]) {
    const found = intervalsBelow(envelope, level, left, right);
    for (let u = left; u <= right; u += step) {
      const heights = envelope.filter((s) => u > s.u0 && u < s.u1).map((s) => valueAt(s.piece, u));
      if (heights.some((v) => Math.abs(v - level) < step * step)) continue;
      if (found.some(({ from, to }) => u >= from && u <= to) !== heights.every((v) => v <= level))
        wrong.push({ level, u });
    }
    found.slice(1).forEach(({ from }, i) => expect(from).toBeGreaterThan(found[i]?.to ?? Infinity));
  }
  expect(wrong).toEqual([]);
});
