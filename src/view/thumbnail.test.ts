import { describe, expect, test } from "vitest";
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

describe("a milled part seen from above, Y up", () => {
  const move = (kind: "rapid" | "feed", from: [number, number, number], to: [number, number, number], radius = 3) => ({
    kind,
    from: { x: from[0], y: from[1], z: from[2] },
    to: { x: to[0], y: to[1], z: to[2] },
    radius,
  });
  const stock = { left: -20, right: 60, low: -8, high: 24, bottom: -15, top: 1 };
  const path = [
    move("rapid", [900, 900, 50], [10, 4, 2]),
    move("feed", [10, 4, 2], [10, 4, -3]),
    move("feed", [10, 4, -3], [42, 20, -3]),
  ];

  test("without stock it is as large as the ways of its feeds", () => {
    expect(planeThumbnailOf(path)).toEqual({
      box: [8, -22, 36, 20],
      part: "",
      blank: "",
      milled: { stock: null, ways: [{ d: "M10 -4L10 -4M10 -4L42 -20", wide: 6 }] },
    });
    expect(planeThumbnailOf(path.slice(0, 1))).toBeNull();
  });

  test("in its stock only what is below the top counts, each tool by its ⌀", () => {
    const over = move("feed", [0, 0, 1], [30, 0, 1]),
      other = move("feed", [0, 9, -2], [30, 9, -2], 5);
    expect(planeThumbnailOf([over], stock)).toBeNull();
    const made = planeThumbnailOf([...path, over, other], stock);
    expect(made?.milled?.stock).toEqual([-20, -24, 80, 32]);
    expect(made?.milled?.ways.map(({ wide }) => wide)).toEqual([6, 10]);
    expect(made?.milled?.ways[1]?.d).toBe("M0 -9L30 -9");
  });

  test("a path of 200,000 moves is drawn without those that lie on others", () => {
    const long = Array.from({ length: 200_000 }, (_, i) => move("feed", [i % 7, 0, -1], [(i + 1) % 7, 5, -1]));
    const made = planeThumbnailOf(long);
    expect(made?.box).toEqual(planeThumbnailOf(long.slice(0, 14))?.box);
    expect(made?.milled?.ways[0]?.d.split("M")).toHaveLength(8);
  });

  test("arcs stay round", () => {
    const arc = {
      ...move("feed", [10, 0, -3], [-10, 0, -3]),
      kind: "arc" as const,
      centre: { x: 0, y: 0 },
      turn: "ccw" as const,
    };
    const places = planeThumbnailOf([arc], stock)?.milled?.ways[0]?.d.slice(1).split("L") ?? [];
    expect(places.length).toBeGreaterThan(6);
    for (const place of places) expect(Math.hypot(...place.split(" ").map(Number))).toBeCloseTo(10, 1);
  });
});
