import { expect, test } from "vitest";
import { part, type Segment } from "../../kernel/geometry/point.ts";
import { contourDrawing } from "./contour-drawing.ts";
import { labelsOverlap, textBox } from "../dimensions/labels.ts";

const places = [
  [0, 14],
  [-1, 15],
  [-20, 15],
  [-28, 12],
  [-38, 12],
  [-44, 21],
  [-55, 21],
  [-55, 30],
] as const;
const contour = places.slice(1).map(([z, r], i): Segment => ({
  kind: "line",
  from: part.point(places[i]?.[0] ?? 0, places[i]?.[1] ?? 0),
  to: part.point(z, r),
}));
const drawn = (size: { width: number; height: number }, xUp = true) =>
  contourDrawing({
    contour,
    rowOfSegment: contour.map((_, i) => i + 1),
    ends: places.map(([z, r]) => ({ x: 2 * r, z })),
    faulty: new Set(),
    active: null,
    size,
    xUp,
  });

test.each([
  [640, 700],
  [640, 260],
  [380, 240],
  [1500, 900],
])("on a sheet of %d × %d numbers cover neither each other nor a point", (width, height) => {
  const { points } = drawn({ width, height });
  const boxes = points.map(({ row, label }) => label && textBox(label, String(row + 1), 0, 12));
  expect(boxes.filter(Boolean).length).toBeGreaterThan(places.length / 2);
  boxes.forEach((box, i) => {
    if (!box) return;
    for (const other of boxes.slice(0, i)) if (other) expect(labelsOverlap(box, other)).toBe(false);
    for (const { place } of points)
      expect(labelsOverlap(box, { x: place.x - 5, y: place.y - 5, width: 10, height: 10 })).toBe(false);
  });
});

test.each([true, false])("most of the free height is on the side of the contour (X upwards: %s)", (xUp) => {
  const height = 900,
    { camera } = drawn({ width: 500, height }, xUp),
    beyond = xUp ? height - camera.zero.y : camera.zero.y;
  const high = 30 * camera.scale;
  expect(beyond).toBeLessThan(0.3 * (height - high));
  expect(beyond).toBeGreaterThan(20);
});
