import { expect, test } from "vitest";
import { at } from "../kernel/geometry/point.ts";
import { leastCovering, labelPlaces } from "./edge-label.ts";
import type { Camera } from "./camera.ts";

const room = { left: 60, right: 415, top: 14, bottom: 280 },
  size = { width: 86, height: 33 };
const camera: Camera = { scale: 2.5, zero: { x: 301, y: 153 }, xUp: true };
const picture = { camera, size: { width: 480, height: 300 } };
const none = { boxes: [], areas: [], lines: [] };

test("the place beside the mark comes first; all places fit the room, and those above and below clear the mark's height", () => {
  const places = labelPlaces({ x: 415, y: 97.5 }, size, room);
  expect(places[0]).toEqual({ x: 317, y: 81, width: 86, height: 33 });
  for (const { y } of places) {
    expect(y).toBeGreaterThanOrEqual(room.top);
    expect(y + size.height).toBeLessThanOrEqual(room.bottom);
  }
  for (const { y } of places.slice(1)) expect(y > 97.5 || y + size.height < 97.5).toBe(true);
});
test("at the left edge the text stands to the right of the mark", () =>
  expect(labelPlaces({ x: 60, y: 97.5 }, size, room)[0]?.x).toBe(72));
test("at the upper edge no text is placed above the mark", () =>
  expect(Math.min(...labelPlaces({ x: 200, y: 14 }, size, room).map(({ y }) => y))).toBe(14));

test("a line through the first place moves the text above it, one beside it does not", () => {
  const places = labelPlaces({ x: 415, y: 97.5 }, size, room);
  const along = (r: number) => ({ ...none, lines: [[at(-90, r), at(31, r)]] });
  expect(leastCovering(places, along(22.2), picture, 0)).toBe(1);
  expect(leastCovering(places, along(30.3), picture, 0)).toBe(0);
});
test("a line that slants past a corner of the box is not in the way", () => {
  const places = labelPlaces({ x: 415, y: 97.5 }, size, room);
  // From below the box to the right of it, round its lower right corner.
  expect(leastCovering(places, { ...none, lines: [[at(38, 10), at(46, 20)]] }, picture, 0)).toBe(0);
  expect(leastCovering(places, { ...none, lines: [[at(30, 10), at(40, 20)]] }, picture, 0)).toBe(1);
});
test("without free space the text covers lines rather than a mark, and keeps its place", () => {
  const places = labelPlaces({ x: 415, y: 97.5 }, size, room);
  const lines = [-100, -40, 0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50].map((r) => [at(-90, r), at(60, r)]);
  const boxes = [{ x: 300, y: 60, width: 100, height: 60 }];
  const first = leastCovering(places, { ...none, boxes, lines }, picture, 0);
  expect(places[first]?.y === undefined || places[first].y >= 120 || places[first].y + 33 <= 60).toBe(true);
  const free = leastCovering(places, none, picture, 3);
  expect(free).toBe(3);
});

const mark = { x: 415, y: 97.5 };
test("above and below the mark the text may also be in line with the mark, farther from the work", () => {
  const right = labelPlaces(mark, size, room).map(({ x, width }) => x + width);
  expect(new Set(right)).toEqual(new Set([403, 425]));
  expect(labelPlaces({ x: 60, y: 97.5 }, size, room).map(({ x }) => x)).toContain(50);
});
test("a text held back by the picture edge does not cover the mark", () => {
  const low = { x: 415, y: 278 };
  for (const { x, y, width, height } of labelPlaces(low, size, room))
    if (x + width > low.x - 9) expect(y + height <= low.y - 9 || y >= low.y + 9).toBe(true);
});
test("no text is placed in the taken corner", () => {
  const taken = { x: 375, y: 0, width: 56, height: 104 };
  const places = labelPlaces(mark, size, room, taken);
  expect(places[0]).toEqual({ x: 289, y: 81, ...size });
  for (const { x, y } of places) expect(x + size.width <= taken.x || y >= taken.height).toBe(true);
});
test.each([
  [
    "on the free background beside the work, in line with the mark rather than beside it",
    { x: 100, y: 20, width: 236, height: 250 },
    339,
  ],
  ["all of it on the work: it stays beside the mark", { x: 0, y: 0, width: 480, height: 300 }, 317],
  ["half of it on the work rather than all of it", { x: 100, y: 20, width: 275, height: 250 }, 339],
])("%s", (_, work, x) => {
  const places = labelPlaces(mark, size, room);
  expect(places[leastCovering(places, { ...none, areas: [work] }, picture, 0)]?.x).toBe(x);
});
test("a mark stays free even if the text then covers the work", () => {
  const places = labelPlaces(mark, size, room),
    boxes = [{ x: 405, y: 0, width: 40, height: 300 }];
  expect(
    places[leastCovering(places, { ...none, boxes, areas: [{ x: 0, y: 0, width: 480, height: 300 }] }, picture, 1)]?.x,
  ).toBe(317);
});
