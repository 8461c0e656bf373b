import fc from "fast-check";
import { expect, test } from "vitest";

import flange from "../../examples/flange.h?raw";
import { areaOfRing } from "../../kernel/area/area.ts";
import { difference } from "../../kernel/area/clip.ts";
import { parse } from "../../nc/parse.ts";
import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { GRID } from "../../kernel/tolerance.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import { sameBlank, stockAt } from "../../sim/stock.ts";
import { fitted, type Bounds } from "../camera.ts";
import { patchOf, patchWithin, changedBox, turnedPatchOf } from "./changed-box.ts";

const made = run(parse(flange), { tools: shippedTools, rapid: 10_000 });
const simulation = simulate(made);
const moment = fc.record({
  step: fc.nat({ max: made.steps.length }),
  fraction: fc.double({ min: 0, max: 1, noNaN: true }),
});
/**
 * Rounding to the grid of the polygon engine: where a cut ends on a long edge, the whole edge turns by part of a grid
 * line, so that a sliver as long as the edge and thinner than two grid lines differs.
 */
const isSliver = (ring: Ring) => Math.abs(areaOfRing(ring)) < GRID * aroundOf(ring);
const aroundOf = (ring: Ring) => ring.reduce((sum, p, i) => sum + sizeBetween(p, ring[(i + 1) % ring.length] as Pt), 0);
const sizeBetween = (p: Pt, q: Pt) => Math.hypot(q.z - p.z, q.r - p.r);
const ringOf = ({ left, right, low, high }: Bounds): Ring => [
  at(left, low),
  at(right, low),
  at(right, high),
  at(left, high),
];

test("all differences between two moments lie in the touched box", () => {
  let compared = 0;
  fc.assert(
    fc.property(moment, moment, (one, other) => {
      const box = changedBox(made.steps, one, other);
      if (box === "all") return;
      const [a, b] = [stockAt(simulation, one), stockAt(simulation, other)];
      const differs = [...difference(a, b), ...difference(b, a)];
      const outside = box ? difference(differs, [ringOf(box)]) : differs;
      expect(outside.filter((ring) => !isSliver(ring))).toEqual([]);
      compared += differs.filter((ring) => !isSliver(ring)).length;
    }),
    {
      numRuns: 60,
      examples: [
        [
          { step: 257, fraction: 0 },
          { step: 256, fraction: 0 },
        ],
      ],
    },
  );
  expect(compared).toBeGreaterThan(20);
});

test("distant moments are not compared move by move, and the same moment touches nothing", () => {
  const long = Array.from({ length: 1000 }, (_, i) => made.steps[i % made.steps.length]).flatMap((step) => step ?? []);
  expect(changedBox(long, { step: 3, fraction: 0.4 }, { step: 871, fraction: 0.1 })).toBe("all");
  expect(changedBox(made.steps, { step: 7, fraction: 0 }, { step: 7, fraction: 0 })).toBeNull();
});

test("a patch covers its box on whole pixels of the device, whichever way X grows", () => {
  const box = { left: -21.37, right: -4.81, low: 17.03, high: 22.9 },
    ratio = 1.5;
  for (const xUp of [true, false]) {
    const camera = fitted(
      { left: -63.7, right: 11.3, low: 0, high: 41.9 },
      { width: 731, height: 433 },
      {
        left: 0,
        right: 0,
        top: 0,
        bottom: 0,
      },
      xUp,
    );
    const { x, y, width, height } = patchOf(box, camera, ratio);
    for (const edge of [x, y, width, height]) expect(edge * ratio).toBeCloseTo(Math.round(edge * ratio), 9);
    const [top, floor] = xUp
      ? [camera.zero.y - camera.scale * box.high, camera.zero.y - camera.scale * box.low]
      : [camera.zero.y + camera.scale * box.low, camera.zero.y + camera.scale * box.high];
    expect(y).toBeLessThan(top);
    expect(y + height).toBeGreaterThan(floor);
    expect(x).toBeLessThan(camera.zero.x + box.left * camera.scale);
    expect(x + width).toBeGreaterThan(camera.zero.x + box.right * camera.scale);
  }
  expect(patchWithin({ x: -40, y: 12, width: 30, height: 9 }, { x: 0, y: 0, width: 731, height: 433 })).toBeNull();
  expect(patchWithin({ x: -40, y: 12, width: 57, height: 9 }, { x: 0, y: 0, width: 731, height: 433 })).toEqual({
    x: 0,
    y: 12,
    width: 17,
    height: 9,
  });
});

test("a patch covers the visible differences on both sides, on whole pixels of the device", () => {
  const camera = fitted(
    { left: -63.7, right: 11.3, low: 0, high: 41.9 },
    { width: 731, height: 433 },
    {
      left: 0,
      right: 0,
      top: 0,
      bottom: 0,
    },
    true,
  );
  const box = { left: -21.37, right: -4.81, low: 17.03, high: 22.9 },
    ratio = 1.5;
  for (const [outer, along] of [
    [31.7, 0],
    [21.3, 1.7],
  ] as const) {
    const { x, y, width, height } = turnedPatchOf(box, camera, { outer, along }, ratio);
    const far = outer > box.high ? box.high : outer;
    for (const edge of [x, y, width, height]) expect(edge * ratio).toBeCloseTo(Math.round(edge * ratio), 9);
    expect(y).toBeLessThan(camera.zero.y - camera.scale * far);
    expect(y).toBeGreaterThan(camera.zero.y - camera.scale * far - 6);
    expect(y + height).toBeGreaterThan(camera.zero.y + camera.scale * far);
    expect(x).toBeLessThan(camera.zero.x + (box.left - along) * camera.scale);
    expect(x).toBeGreaterThan(camera.zero.x + (box.left - along) * camera.scale - 6);
    expect(x + width).toBeGreaterThan(camera.zero.x + (box.right + along) * camera.scale);
  }
});

test.each([
  [1, 1],
  [2, 1],
  [3, 1],
  [1.5, 2],
  [1.25, 4],
  [1.1, 10],
  [4 / 3, 3],
])("at %s device pixels per CSS pixel a patch covers whole pixels of both", (ratio, whole) => {
  const camera = { scale: 3.713, zero: { x: 211.37, y: 97.81 }, xUp: true };
  const { x, y, width, height } = turnedPatchOf(
    { left: -21.37, right: -4.81, low: 17.03, high: 22.9 },
    camera,
    {
      outer: 30,
      along: 0,
    },
    ratio,
  );
  for (const edge of [x, y, width, height]) expect(edge / whole).toBeCloseTo(Math.round(edge / whole), 9);
  expect(camera.zero.x - 21.37 * camera.scale - x).toBeLessThanOrEqual(3 + whole);
});
test("on a device without common whole pixels a patch uses device pixels alone", () => {
  const camera = { scale: 3.7, zero: { x: 211.3, y: 97 }, xUp: true };
  const { x } = turnedPatchOf(
    { left: -21.37, right: 0, low: 0, high: 22.9 },
    camera,
    { outer: 30, along: 0 },
    Math.SQRT2,
  );
  expect(x * Math.SQRT2).toBeCloseTo(Math.round(x * Math.SQRT2), 9);
});

test("a newly stated blank separates the moments before it from those after it", () => {
  const marks = sameBlank({
    checkpoints: [
      { step: 0, stock: null },
      { step: 9, stock: null, isStated: true },
    ],
  });
  expect(marks({ step: 3, fraction: 0.2 }, { step: 8, fraction: 0.9 })).toBe(true);
  expect(marks({ step: 3, fraction: 0.2 }, { step: 9, fraction: 0 })).toBe(false);
  expect(marks({ step: 9, fraction: 0 }, { step: 41, fraction: 0.7 })).toBe(true);
});
