import { expect, test } from "vitest";
import { limited, NARROWEST, widest, widthByKey } from "./columns.ts";

const ROOM = 1440;

test.each([
  ["left", "ArrowRight", 336],
  ["left", "ArrowLeft", 304],
  ["right", "ArrowRight", 304],
  ["right", "ArrowLeft", 336],
  ["left", "Home", NARROWEST.left],
  ["right", "End", 576],
  ["left", "Enter", undefined],
  ["left", "a", null],
  ["left", "Tab", null],
] as const)("the %s separator and %s", (side, key, width) => {
  expect(widthByKey(key, side, { width: 320, room: ROOM })).toBe(width);
});

test("a column is never narrower than its limit, nor wider than its share of the window", () => {
  expect(limited("left", 20, ROOM)).toBe(NARROWEST.left);
  expect(limited("right", 900.4, ROOM)).toBe(widest("right", ROOM));
  expect(limited("left", 333.4, ROOM)).toBe(333);
  expect(widest("left", 300)).toBe(NARROWEST.left);
});
