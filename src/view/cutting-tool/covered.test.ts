import { expect, test } from "vitest";
import { at, type Pt } from "../../kernel/geometry/point.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { toScreen, type Camera, type Place } from "../camera.ts";
import { liesInward, windowsOf } from "./covered.ts";
import { silhouetteOf } from "./silhouette.ts";

const size = { width: 730, height: 411 },
  camera: Camera = { scale: 3.7, zero: { x: 512.5, y: 203 }, xUp: true };
/** A shaft of two diameters, with a bore. */
const work = silhouetteOf([
  [at(-63.7, 4.1), at(0.7, 4.1), at(0.7, 25.3), at(-31.2, 25.3), at(-31.2, 38.5), at(-63.7, 38.5)],
]);

/** Whether a value of `clip-path` shows a place, by counting the polygon's sides that a ray from the place crosses. */
function shows(clip: string, { x, y }: Place): boolean {
  const corners = clip
    .replace("polygon(evenodd, ", "")
    .replaceAll(/px|[)]/g, "")
    .split(", ")
    .map((pair) => pair.split(" ").map(Number));
  return (
    corners.filter(([x0 = 0, y0 = 0], i) => {
      const [x1 = 0, y1 = 0] = corners[(i + 1) % corners.length] ?? [];
      return y0 > y !== y1 > y && x < x0 + ((x1 - x0) * (y - y0)) / (y1 - y0);
    }).length %
      2 ===
    1
  );
}
const seenOf = (section: "half" | "outside", p: Pt, look: Camera = camera) => {
  const { seen, other } = windowsOf(section, look, size, work) ?? expect.fail("something is covered"),
    place = toScreen(look, p);
  return [shows(seen, place), shows(other, place)];
};

test("boring bars and drills lie inward, tools for outside turning do not", () => {
  expect(shippedTools.filter(liesInward).map(({ NAME }) => NAME)).toMatchInlineSnapshot(`
    [
      "BORE-CCMT-80-R04",
      "BORE-DCMT-55-R04",
      "THREAD-60-ID",
      "ID-RECTURN-2",
    ]
  `);
});

test("from outside, the work hides everything nearer to the axis than its edge, on both sides", () => {
  expect(seenOf("outside", at(-47.3, 33))).toEqual([false, true]);
  expect(seenOf("outside", at(-47.3, -33))).toEqual([false, true]);
  expect(seenOf("outside", at(-12.4, 33))).toEqual([true, false]);
  expect(seenOf("outside", at(-12.4, -21))).toEqual([false, true]);
  expect(seenOf("outside", at(4.2, 1.5))).toEqual([true, false]);
});

test.each([
  ["up", camera],
  ["down", { ...camera, xUp: false }],
])("half section, X %s: open on the tool's side, covered beyond the axis", (_, look) => {
  expect(seenOf("half", at(-47.3, 33), look)).toEqual([true, false]);
  expect(seenOf("half", at(-12.4, -21), look)).toEqual([false, false]);
  expect(seenOf("half", at(-12.4, -33), look)).toEqual([false, true]);
  expect(seenOf("half", at(4.2, -1.5), look)).toEqual([false, true]);
});

test("a full section hides nothing, nor does a place without work", () => {
  expect(windowsOf("full", camera, size, work)).toBeNull();
  expect(windowsOf("half", camera, size, silhouetteOf([]))).toBeNull();
});
