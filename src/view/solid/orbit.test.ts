import fc from "fast-check";
import { expect, test } from "vitest";
import { approached, axesOf, eyeOf, FIELD, NAMED_VIEWS, namedView, orbited, pixelAt, slid, viewBetween, type SpacePoint } from "./orbit.ts";

const bounds = { left: -100.4, right: 22.7, low: 0, high: 41.3 };
const dot = (a: SpacePoint, b: SpacePoint) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const less = (a: SpacePoint, b: SpacePoint): SpacePoint => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

test("from the front Z goes to the right and X up, as in the section; the end view looks at the face", () => {
  const size = { width: 800, height: 600 };
  expect(axesOf(namedView("front", bounds, size))).toEqual({ eye: [0, 1, 0], right: [0, -0, 1], up: [1, -0, -0] });
  const end = axesOf(namedView("end", bounds, size));
  expect(end.eye[2]).toBeCloseTo(1, 12);
  expect(end.up[0]).toBe(1);
});

test("named views show the whole body in any picture, and not small", () => {
  const side = fc.integer({ min: 90, max: 4000 });
  fc.assert(fc.property(side, side, fc.constantFrom(...NAMED_VIEWS), (width, height, name) => {
    const size = { width, height }, view = namedView(name, bounds, size), { eye, right, up } = axesOf(view), from = eyeOf(view);
    const share = [bounds.left, bounds.right].flatMap((z) =>
      Array.from({ length: 16 },
        (_, i): SpacePoint => [bounds.high * Math.cos((i * Math.PI) / 8), bounds.high * Math.sin((i * Math.PI) / 8), z])
    ).map((p) => {
      const seen = less(p, from), away = -dot(seen, eye), half = away * Math.tan(FIELD / 2);
      return Math.max(Math.abs(dot(seen, up)) / half, Math.abs(dot(seen, right)) / ((half * width) / height));
    });
    expect(Math.max(...share)).toBeLessThanOrEqual(1);
    expect(Math.max(...share)).toBeGreaterThan(0.5);
  }));
});

test("what lies under the finger goes along with it", () => {
  const size = { width: 731, height: 517 }, view = orbited(namedView("iso", bounds, size), 0.31, -0.2), moved = slid(view, 37, -21, size);
  const { right, up } = axesOf(view), way = less(view.centre, moved.centre);
  expect(dot(way, right) / pixelAt(view, size)).toBeCloseTo(37, 9);
  expect(-dot(way, up) / pixelAt(view, size)).toBeCloseTo(-21, 9);
});

test("the eye never turns over, and nears by a factor within limits", () => {
  const view = namedView("iso", bounds, { width: 400, height: 400 });
  expect(axesOf(orbited(view, 0, 17)).up[0]).toBeGreaterThan(0);
  expect(axesOf(orbited(view, 0, -17)).up[0]).toBeGreaterThan(0);
  expect(approached(view, 1.4).distance).toBeCloseTo(view.distance / 1.4, 9);
  expect(approached(view, 1e9).distance).toBe(0.5);
});

test("the way between two views turns the shorter way round and ends exactly", () => {
  const size = { width: 400, height: 300 }, front = namedView("front", bounds, size), end = namedView("end", bounds, size);
  const far = orbited(front, 2 * Math.PI - 0.1, 0.2);
  expect(Math.abs(viewBetween(far, end, 0.5).turn - far.turn)).toBeLessThan(1);
  expect(viewBetween(far, end, 1)).toEqual(end);
  expect(viewBetween(front, end, 0)).toEqual(front);
});
