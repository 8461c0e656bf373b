import { expect, test } from "vitest";
import { at } from "../kernel/geometry/point.ts";
import { planeThumbnailOf, thumbnailOf } from "./thumbnail.ts";

const ring = (...points: [number, number][]) => points.map(([z, r]) => at(z, r));
const blank = [ring([-71.3, 0], [0.7, 0], [0.7, 20.4], [-71.3, 20.4])];

test("the part lies in its blank, the box holds both sides of the axis, and X points up", () => {
  const made = thumbnailOf(blank, [ring([-71.3, 0], [0, 0], [0, 12.6], [-40.2, 12.6], [-40.2, 20.4], [-71.3, 20.4])]);
  expect(made?.part).toBe("M-71.3 0L0 0L0 -12.6L-40.2 -12.6L-40.2 -20.4L-71.3 -20.4Z");
  expect(made?.blank).toContain("L0.7 -20.4");
  const [left, top, width, height] = made?.box ?? [0, 0, 0, 0];
  expect(left).toBeLessThan(-71.3);
  expect(left + width).toBeGreaterThan(0.7);
  expect(top).toBeLessThan(-20.4);
  expect(top + height).toBeCloseTo(-top, 6);
});

test("a fine arc of a thousand points is reduced to few", () => {
  const arc = Array.from({ length: 1000 }, (_, i) => at(-i * 0.07, 9 + 3 * Math.sin(i / 300)));
  expect(thumbnailOf(blank, [[...arc, at(-70, 0), at(0, 0)]])?.part.length).toBeLessThan(6000);
});

test("without a part there is no picture", () => expect(thumbnailOf(blank, [])).toBeNull());

test("a milling path is seen from above, without its rapids, Y up", () => {
  const move = (kind: string, from: [number, number], to: [number, number]) => ({
    kind,
    from: { x: from[0], y: from[1] },
    to: { x: to[0], y: to[1] },
  });
  const path = [move("rapid", [900, 900], [10, 4]), move("feed", [10, 4], [42, 20])];
  expect(planeThumbnailOf(path)).toEqual({ box: [8, -22, 36, 20], part: "", blank: "", plane: "M10 -4L42 -20" });
  expect(planeThumbnailOf(path.slice(0, 1))).toBeNull();
});
