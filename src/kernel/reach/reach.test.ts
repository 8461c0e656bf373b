import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { edgeEnd, edgeStart, extent, grownRound, inFrame, type Convex, type Edge } from "./convex.ts";
import { heightAt, linePiece, staysAbove, upperEnvelope, valueAt } from "./envelope.ts";
import { flat, type Flat, type FlatSegment } from "../geometry/flat.ts";
import { insertShape } from "../cutter/insert.ts";
import { reachOver, type Bound } from "./reach.ts";
import type { Tool } from "../plan/tool.ts";
import { degrees, length } from "../units.ts";

const tools: Tool[] = [
  {
    T: 1,
    NAME: "A",
    TYPE: "ROUGH",
    TO: 1,
    RS: length(0.8),
    "T-ANGLE": degrees(95),
    "P-ANGLE": degrees(80),
    CUTLENGTH: length(12),
  },
  {
    T: 2,
    NAME: "B",
    TYPE: "FINISH",
    TO: 1,
    RS: length(0.4),
    "T-ANGLE": degrees(93),
    "P-ANGLE": degrees(35),
    CUTLENGTH: length(16),
  },
  {
    T: 3,
    NAME: "C",
    TYPE: "BUTTON",
    TO: 2,
    RS: length(3),
  },
  { T: 4, NAME: "D", TYPE: "RECTURN", TO: 2, RS: length(0.2), CUTWIDTH: length(3), CUTLENGTH: length(30) },
  {
    T: 5,
    NAME: "E",
    TYPE: "THREAD",
    TO: 2,
    RS: length(0.1),
  },
  {
    T: 6,
    NAME: "F",
    TYPE: "ROUGH",
    TO: 1,
    RS: length(0),
    "T-ANGLE": degrees(75),
    "P-ANGLE": degrees(60),
    CUTLENGTH: length(9),
  },
];
/** Longitudinal outside towards −Z. */
const frame = { transverse: false, signU: -1, signV: 1 } as const;

/** Points of the lower boundary of an insert, dense. */
function dense(k: Convex): Flat[] {
  return k.flatMap((e) =>
    Array.from({ length: 101 }, (_, i): Flat =>
      e.kind === "line"
        ? { u: e.from.u + ((e.to.u - e.from.u) * i) / 100, v: e.from.v + ((e.to.v - e.from.v) * i) / 100 }
        : flat.onCircle(e.centre, e.radius, e.start + (e.sweep * i) / 100),
    ),
  );
}

const contour = fc
  .array(fc.record({ du: fc.integer({ min: 50, max: 6000 }), dv: fc.integer({ min: -5000, max: 5000 }) }), {
    minLength: 1,
    maxLength: 6,
  })
  .map((steps): FlatSegment[] => {
    let at: Flat = { u: 0, v: 0 };
    return steps.map((s) => {
      const from = at;
      at = { u: from.u + s.du / 1000, v: from.v + s.dv / 1000 };
      return { kind: "line", from, to: at };
    });
  });

describe("the reach of an insert over a contour", () => {
  test.each(tools)("$NAME touches and never cuts: it agrees with trying every point", (tool) => {
    const insert = inFrame(insertShape(tool), frame);
    const edge = dense(insert);
    fc.assert(
      fc.property(contour, fc.integer({ min: -3000, max: 20000 }), (chain, at) => {
        const e = reachOver(
          chain.map((segment) => ({ segment, on: "contour" })),
          insert,
        );
        const u = at / 1000;
        // The highest lift required by any pair of a contour point and an insert point.
        const ground = (x: number) => {
          const s = chain.find((c) => c.from.u <= x && x <= c.to.u);
          return s ? s.from.v + ((s.to.v - s.from.v) * (x - s.from.u)) / (s.to.u - s.from.u) : -Infinity;
        };
        const tried = Math.max(
          ...edge.map((q) => ground(u + q.u) - q.v),
          ...chain
            .flatMap((s) => [s.from, s.to])
            .flatMap((p) => edge.filter((q) => Math.abs(q.u + u - p.u) < 1e-9).map((q) => p.v - q.v)),
        );
        const exact = heightAt(e, u);
        if (tried === -Infinity) return;
        expect(exact).toBeGreaterThanOrEqual(tried - 1e-6);
      }),
      { numRuns: 200 },
    );
  });

  test("is the contour itself for a sharp needle, and its offset for a circle", () => {
    const circle = inFrame(insertShape(tools[2] as Tool), frame);
    const slope: FlatSegment[] = [{ kind: "line", from: { u: 0, v: 0 }, to: { u: 40, v: 30 } }];
    const e = reachOver(
      slope.map((segment) => ({ segment, on: "contour" })),
      circle,
    );
    // The centre runs 3 mm off the slope 3:4, the tip 3 mm below the centre.
    expect(heightAt(e, 20)).toBeCloseTo(15 + 3 / 0.8 - 3, 9);
  });

  test("a valley arc smaller than the nose is bridged, a larger one is followed by the difference of the radii", () => {
    const circle = inFrame(insertShape(tools[2] as Tool), frame);
    const bowl = (r: number): FlatSegment[] => [
      { kind: "line", from: { u: -20, v: r }, to: { u: -r, v: r } },
      {
        kind: "arc",
        from: { u: -r, v: r },
        to: { u: r, v: r },
        centre: { u: 0, v: r },
        turn: "ccw",
      },
      { kind: "line", from: { u: r, v: r }, to: { u: 20, v: r } },
    ];
    const over = (r: number) =>
      reachOver(
        bowl(r).map((segment) => ({ segment, on: "contour" })),
        circle,
      );
    expect(heightAt(over(5), 0)).toBeCloseTo(0, 9);
    expect(heightAt(over(2), 0)).toBeCloseTo(2 - (3 - Math.sqrt(9 - 4)), 9);
  });

  test("a contour that begins with an overhang is touched at its first point as well", () => {
    const circle = inFrame(insertShape(tools[2] as Tool), frame);
    // A concave arc of radius 2 that leaves its first point slightly backwards.
    const chain: FlatSegment[] = [
      { kind: "arc", from: { u: 0, v: 0 }, to: { u: 2, v: -2 }, centre: { u: 2, v: -1e-3 }, turn: "ccw" },
      {
        kind: "line",
        from: { u: 2, v: -2 },
        to: { u: 9, v: -2 },
      },
    ];
    const e = reachOver(
      chain.map((segment) => ({ segment, on: "contour" })),
      circle,
    );
    // The circle of 3 rests on the first point: its centre one to the right of it is √8 above it, the tip 3 below the
    // centre.
    expect(heightAt(e, 1)).toBeCloseTo(Math.sqrt(8) - 3, 9);
  });
});

describe("a straight line above an envelope", () => {
  const around = { feature: "nose", on: "contour", corner: false } as const;
  const height = fc.integer({ min: -4000, max: 4000 }).map((n) => n / 1000);
  const hills = fc
    .array(fc.tuple(height, height), { minLength: 2, maxLength: 8 })
    .map((line) =>
      upperEnvelope(line.flatMap(([a, b], i) => linePiece({ u: i, v: a }, { u: i + 1, v: b }, around) ?? [])),
    );
  test("is free exactly when no point of it lies under the envelope", () => {
    fc.assert(
      fc.property(hills, height, height, (e, a, b) => {
        const [from, to] = [
          { u: 0.25, v: a },
          { u: e.length - 0.25, v: b },
        ];
        const depths = e.flatMap((s) =>
          [s.u0, s.u1 - 1e-6]
            .map((u) => Math.min(Math.max(u, from.u), to.u))
            .filter((u) => u >= s.u0 && u <= s.u1)
            .map((u) => valueAt(s.piece, u) - (a + ((b - a) * (u - from.u)) / (to.u - from.u))),
        );
        const deepest = Math.max(...depths);
        fc.pre(Math.abs(deepest) > 1e-4);
        expect(staysAbove(e, from, to)).toBe(deepest < 0);
      }),
    );
  });
});

test("an insert grown by a disc keeps that distance from a corner, a line and an arc, with arcs that stay arcs", () => {
  const corner: Bound[] = [flat.line({ u: -10, v: 2 }, { u: 0, v: 2 }), flat.line({ u: 0, v: 2 }, { u: 0, v: -3 })].map(
    (segment) => ({
      segment,
      on: "contour" as const,
    }),
  );
  const tip = grownRound(insertShape({ T: 1, NAME: "", TYPE: "BUTTON", TO: 9, RS: length(0.8) }), 1.3);
  const e = reachOver(corner, tip);
  for (const u of [-7, -0.4, 0, 0.6, 1.7]) {
    const v = heightAt(e, u);
    const nearest = Math.hypot(Math.max(0, u), v - 2);
    expect(nearest).toBeCloseTo(2.1, 9);
  }
  expect(e.some((s) => s.piece.arc === 1)).toBe(true);
});

test("a corner of an insert grown by a disc becomes an arc of that radius", () => {
  const square = [
    [0, 0],
    [3, 0],
    [3, 2],
    [0, 2],
  ].map(([u, v], i, all): Edge => {
    const [p, q] = all[(i + 1) % 4] as [number, number];
    return { kind: "line", from: { u: u as number, v: v as number }, to: { u: p, v: q }, feature: "width" };
  });
  const grownBy = grownRound(square, 0.7);
  expect(grownBy.map((e) => e.kind)).toEqual(["line", "arc", "line", "arc", "line", "arc", "line", "arc"]);
  expect(extent(grownBy)).toEqual({ minU: -0.7, maxU: 3.7, minV: -0.7, maxV: 2.7 });
  grownBy.forEach((e, i) => {
    const next = grownBy[(i + 1) % grownBy.length] as Edge;
    expect(Math.hypot(edgeEnd(e).u - edgeStart(next).u, edgeEnd(e).v - edgeStart(next).v)).toBeLessThan(1e-9);
  });
});

test("an arc whose rounded end is off its circle leaves no gap to the next element", () => {
  const centre = { u: 0, v: 0 };
  const arc = (end: number): Bound => ({
    segment: { kind: "arc", from: { u: 0, v: 0.5 }, to: { u: 0.473, v: end }, centre, turn: "cw" },
    on: "contour",
  });
  const bar = tools.find(({ TYPE }) => TYPE === "RECTURN");
  // On the circle it would end at 0.162: once outside, once inside.
  for (const end of [0.163, 0.161]) {
    const line: Bound = {
      segment: { kind: "line", from: { u: 0.473, v: end }, to: { u: 4, v: -10 } },
      on: "contour",
    };
    const envelope = bar ? reachOver([arc(end), line], insertShape(bar)) : [];
    const gaps = envelope.slice(1).filter(({ u0 }, i) => u0 - (envelope[i]?.u1 ?? u0) > 1e-9);
    expect(envelope.length).toBeGreaterThan(1);
    expect(gaps).toEqual([]);
  }
});
