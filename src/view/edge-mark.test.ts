import { expect, test } from "vitest";
import { edgeMark } from "./edge-mark.ts";

const shown = { left: 46, right: 431, top: 3, bottom: 297 };

test("a place in the picture has no mark, nor has one exactly on the edge", () => {
  expect(edgeMark({ x: 100.3, y: 50 }, shown)).toBeNull();
  expect(edgeMark({ x: 431, y: 297 }, shown)).toBeNull();
});
test.each([
  ["right of it", { x: 611, y: 88.5 }, { x: 431, y: 88.5 }, 0],
  ["above it", { x: 77, y: -40 }, { x: 77, y: 3 }, -90],
  ["below and left of it", { x: 26, y: 317 }, { x: 46, y: 297 }, 135],
])("%s: on the nearest edge, pointing there", (_, place, at, turn) =>
  expect(edgeMark(place, shown)).toEqual({ at, turn }),
);
