import { expect, test } from "vitest";
import { at } from "../../kernel/point.ts";
import { shippedTools } from "../../program/shipped-tools.ts";
import type { Camera } from "../camera.ts";
import { clipOf, frontOf, liesInward, windowsOf } from "./covered.ts";

const size = { width: 730, height: 411 }, camera: Camera = { scale: 3.7, zero: { x: 512.5, y: 203 }, xUp: true };
const front = frontOf([[at(-63.7, 4.1), at(-1.3, 4.1), at(0.7, 6), at(0.7, 25.3), at(-63.7, 25.3)], [at(-90, 0), at(-71, 0), at(-71, 3)]]);
const face = 512.5 + 0.7 * 3.7;

test("boring bars and drills lie inward, what turns outside does not", () => {
  expect(shippedTools.filter(liesInward).map(({ NAME }) => NAME)).toMatchInlineSnapshot(`
    [
      "BORE-CCMT-80-R04",
      "BORE-DCMT-55-R04",
      "THREAD-60-ID",
      "ID-RECTURN-2",
    ]
  `);
});

test("the work ends at its free end; without work there is no end", () => {
  expect(front).toBe(0.7);
  expect(windowsOf("half", camera, size, frontOf([]))).toBeNull();
});

test("half section: the tool's side is open, the other one shows what is out of the work", () => {
  expect(windowsOf("half", camera, size, front)).toEqual({
    seen: { top: 0, right: 0, bottom: 208, left: 0 },
    other: { top: 203, right: 0, bottom: 0, left: face },
    isHidden: false,
  });
});

test("with X down the section lies below", () => {
  const { seen, other } = windowsOf("half", { ...camera, xUp: false }, size, front) ?? expect.fail("something is covered");
  expect(seen).toEqual({ top: 203, right: 0, bottom: 0, left: 0 });
  expect(other).toEqual({ top: 0, right: 0, bottom: 208, left: face });
});

test("from outside what is in the work is hidden on both sides; a full section hides nothing", () => {
  const { seen, other, isHidden } = windowsOf("outside", camera, size, front) ?? expect.fail("something is covered");
  expect([seen.left, 730 - other.right, isHidden]).toEqual([face, face, true]);
  expect(windowsOf("full", camera, size, front)).toBeNull();
});

test("a window never reaches out of the picture", () => {
  expect(clipOf({ top: -31, right: 0, bottom: 12.25, left: 800 })).toBe("inset(0px 0px 12.25px 800px)");
});
