import fc from "fast-check";
import { expect, test } from "vitest";
import {
  zoomedOrbit,
  axesOf,
  eyeOf,
  FIELD,
  NAMED_VIEWS,
  namedView,
  nearTo,
  orbited,
  pixelAt,
  projected,
  slid,
  viewBetween,
  type SpacePoint,
} from "./orbit.ts";

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
  fc.assert(
    fc.property(side, side, fc.constantFrom(...NAMED_VIEWS), (width, height, name) => {
      const size = { width, height },
        view = namedView(name, bounds, size),
        { eye, right, up } = axesOf(view),
        from = eyeOf(view);
      const share = [bounds.left, bounds.right]
        .flatMap((z) =>
          Array.from({ length: 16 }, (_, i): SpacePoint => [
            bounds.high * Math.cos((i * Math.PI) / 8),
            bounds.high * Math.sin((i * Math.PI) / 8),
            z,
          ]),
        )
        .map((p) => {
          const seen = less(p, from),
            away = -dot(seen, eye),
            half = away * Math.tan(FIELD / 2);
          return Math.max(Math.abs(dot(seen, up)) / half, Math.abs(dot(seen, right)) / ((half * width) / height));
        });
      expect(Math.max(...share)).toBeLessThanOrEqual(1);
      expect(Math.max(...share)).toBeGreaterThan(0.5);
    }),
  );
});

test("the point under the finger follows it", () => {
  const size = { width: 731, height: 517 },
    view = orbited(namedView("iso", bounds, size), 0.31, -0.2),
    moved = slid(view, 37, -21, size);
  const { right, up } = axesOf(view),
    way = less(view.centre, moved.centre);
  expect(dot(way, right) / pixelAt(view, size)).toBeCloseTo(37, 9);
  expect(-dot(way, up) / pixelAt(view, size)).toBeCloseTo(-21, 9);
});

test("the eye never turns over, and nears by a factor within limits", () => {
  const view = namedView("iso", bounds, { width: 400, height: 400 });
  expect(axesOf(orbited(view, 0, 17)).up[0]).toBeGreaterThan(0);
  expect(axesOf(orbited(view, 0, -17)).up[0]).toBeGreaterThan(0);
  expect(zoomedOrbit(view, 1.4).distance).toBeCloseTo(view.distance / 1.4, 9);
  expect(zoomedOrbit(view, 1e9).distance).toBe(0.5);
});

test("the way between two views turns the shorter way round and ends exactly", () => {
  const size = { width: 400, height: 300 },
    front = namedView("front", bounds, size),
    end = namedView("end", bounds, size);
  const far = orbited(front, 2 * Math.PI - 0.1, 0.2);
  expect(Math.abs(viewBetween(far, end, 0.5).turn - far.turn)).toBeLessThan(1);
  expect(viewBetween(far, end, 1)).toEqual(end);
  expect(viewBetween(front, end, 0)).toEqual(front);
});

test("a place is projected where its ray crosses the picture; beside or behind the eye it is not", () => {
  const size = { width: 731, height: 517 },
    view = slid(orbited(namedView("iso", bounds, size), 0.31, -0.2), 44, 13, size);
  expect(projected(view, size, view.centre)).toEqual({ x: 365.5, y: 258.5 });
  const { right, up, eye } = axesOf(view),
    mm = pixelAt(view, size);
  const place = ([0, 1, 2] as const).map((k) => view.centre[k] + 17.3 * mm * right[k] + 8.1 * mm * up[k]);
  const seen = projected(view, size, [place[0] ?? 0, place[1] ?? 0, place[2] ?? 0]);
  expect(seen?.x).toBeCloseTo(365.5 + 17.3, 9);
  expect(seen?.y).toBeCloseTo(258.5 - 8.1, 9);
  const behind = eyeOf(view);
  expect(projected(view, size, [behind[0] + eye[0], behind[1] + eye[1], behind[2] + eye[2]])).toBeNull();
});

test("moving to a place keeps the direction of view and comes nearer", () => {
  const size = { width: 731, height: 517 },
    view = orbited(namedView("iso", bounds, size), 0.31, -0.2);
  const near = nearTo(view, { left: -31.2, right: -30.4, low: 19.9, high: 20.3 }, false);
  expect(near).toMatchObject({ turn: view.turn, rise: view.rise });
  expect(near.distance).toBeLessThan(view.distance / 3);
  const seen = projected(near, size, [20.1, 0, -30.8]);
  expect(seen?.x).toBeCloseTo(365.5, 9);
  expect(seen?.y).toBeCloseTo(258.5, 9);
  expect(nearTo(view, { left: -31.2, right: -30.4, low: 19.9, high: 20.3 }, true).centre[0]).toBeCloseTo(-20.1, 9);
});
