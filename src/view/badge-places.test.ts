import { expect, test } from "vitest";
import { badgePlaces } from "./badge-places.ts";
import type { Place } from "./camera.ts";

const seen = { left: 46, right: 431, top: 3, bottom: 297 };

/** The least distance of two badges along either edge of the picture: under 24 they hide one another. */
const apart = (put: readonly Place[]): number =>
  Math.min(...put.flatMap((a, i) => put.slice(0, i).map((b) => Math.max(Math.abs(a.x - b.x), Math.abs(a.y - b.y)))));

test("a single badge is above and to the right of its place", () => {
  expect(badgePlaces([{ x: 101.5, y: 77 }], seen)).toEqual([{ x: 119.5, y: 59 }]);
});
test("badges that would hide one another form a row above their places, in the order of the places", () => {
  const places = [203.3, 188, 195.7, 218, 210.1].map((x, i) => ({ x, y: 120.4 - i }));
  const put = badgePlaces(places, seen),
    byPlace = put.toSorted((a, b) => places[put.indexOf(a)]!.x - places[put.indexOf(b)]!.x);
  expect(byPlace.map(({ x }) => Math.round(x))).toEqual([155, 179, 203, 227, 251]);
  expect(new Set(put.map(({ y }) => y)).size).toBe(1);
  expect(put[0]?.y).toBeLessThan(100);
});
test("where a row has no room, neighbours share a badge, and no badge overlaps another or leaves the picture", () => {
  const put = badgePlaces(
    Array.from({ length: 21 }, (_, i) => ({ x: 320 + 3.1 * i, y: 120.4 + i })),
    seen,
  );
  expect(new Set(put.map(({ y }) => y)).size).toBe(1);
  const shared = [...new Set(put)];
  expect(shared.map((at) => put.filter((each) => each === at).length)).toEqual([5, 5, 5, 5, 1]);
  expect(put.findLastIndex((at) => at === shared[0])).toBe(4);
  expect(apart(shared)).toBeGreaterThanOrEqual(44);
  for (const { x } of put) expect([x >= 67, x <= 410]).toEqual([true, true]);
});
test("a row keeps clear of the badge of another place", () => {
  const put = badgePlaces(
    [
      { x: 190.5, y: 97 },
      { x: 180, y: 131 },
      { x: 183, y: 133 },
      { x: 187.2, y: 132 },
    ],
    seen,
  );
  expect(put[0]).toEqual({ x: 208.5, y: 79 });
  expect(apart(put)).toBeGreaterThanOrEqual(24);
});
test("at the upper edge a row moves beside another badge rather than down onto the work", () => {
  const put = badgePlaces(
    [{ x: 260.4, y: 54 }, ...Array.from({ length: 6 }, (_, i) => ({ x: 200 + 6.1 * i, y: 57 }))],
    seen,
  );
  for (const { y } of put) expect(y).toBeLessThan(40);
  expect(apart(put)).toBeGreaterThanOrEqual(24);
});
test("near the edge of the picture a badge moves to where it is fully visible", () => {
  const [first, second] = badgePlaces(
    [
      { x: 425, y: 150 },
      { x: 301.5, y: 9 },
    ],
    seen,
  );
  expect(first?.x).toBeLessThanOrEqual(420);
  expect(second?.y).toBeGreaterThanOrEqual(14);
});
test("without free space a badge is placed anyway", () => {
  expect(badgePlaces([{ x: 50, y: 50 }], { left: 40, right: 99, top: 0, bottom: 9 })).toEqual([{ x: 68, y: 32 }]);
});
