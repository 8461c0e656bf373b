import fc from "fast-check";
import { expect, test } from "vitest";
import { at, part, type Segment } from "./point.ts";

const { flattened, flattenedChain, pointOn, polarOf } = part;

const quarter: Segment = { kind: "arc", from: at(2, 10), to: at(0, 12), centre: at(0, 10), turn: "ccw" };

test("the turn decides the direction of an arc", () => {
  expect(polarOf(quarter as never).sweep).toBeCloseTo(Math.PI / 2, 12);
  expect(polarOf({ ...quarter, turn: "cw" } as never).sweep).toBeCloseTo(-1.5 * Math.PI, 12);
});

test("an arc back to its start is a full circle", () => {
  expect(polarOf({ ...quarter, to: quarter.from } as never).sweep).toBeCloseTo(2 * Math.PI, 12);
});

test("the middle of an arc lies on the circle", () => {
  const p = pointOn(quarter, 0.5);
  expect(p.z).toBeCloseTo(Math.SQRT2, 12);
  expect(p.r).toBeCloseTo(10 + Math.SQRT2, 12);
});

test("chords stay within the tolerance, with exact ends", () => {
  const arcs = fc.record({
    size: fc.double({ min: 0.01, max: 500, noNaN: true }),
    start: fc.double({ min: -3, max: 3, noNaN: true }),
    sweep: fc.double({ min: 0.01, max: 6.2, noNaN: true }),
    chord: fc.constantFrom(0.0001, 0.001, 0.01),
  });
  fc.assert(
    fc.property(arcs, ({ size, start, sweep, chord }) => {
      const on = (a: number) => at(size * Math.cos(a), 600 + size * Math.sin(a));
      const points = flattened(
        { kind: "arc", from: on(start), to: on(start + sweep), centre: at(0, 600), turn: "ccw" },
        chord,
      );
      expect(points[0]).toEqual(on(start));
      expect(points.at(-1)).toEqual(on(start + sweep));
      points.slice(1).forEach((p, i) => {
        const q = points[i]!;
        const sagitta = size - Math.hypot((p.z + q.z) / 2, (p.r + q.r) / 2 - 600);
        expect(sagitta).toBeLessThan(chord * 1.001 + 1e-9);
      });
    }),
    { numRuns: 300 },
  );
});

test("a flattened chain contains each joint once", () => {
  const chain: Segment[] = [
    { kind: "line", from: at(5, 10), to: at(2, 10) },
    quarter,
    { kind: "line", from: at(0, 12), to: at(-5, 12) },
  ];
  const points = flattenedChain(chain, 0.1);
  expect(points[0]).toEqual(at(5, 10));
  expect(points.at(-1)).toEqual(at(-5, 12));
  expect(new Set(points.map((p) => `${p.z} ${p.r}`)).size).toBe(points.length);
});
