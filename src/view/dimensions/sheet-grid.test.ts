import fc from "fast-check";
import { expect, test } from "vitest";
import { labelsOverlap, type LabelBox } from "./labels.ts";
import { gridOn, placesOn } from "./sheet-grid.ts";

const SHEET = { width: 321.5, height: 97.25 };
const along = (long: number) =>
  fc.oneof(
    fc.double({ min: -0.4 * long, max: 1.4 * long, noNaN: true }),
    fc.integer({ min: -2, max: 24 }).map((n) => n * 16),
  );
const place = fc.record({ x: along(SHEET.width), y: along(SHEET.height) });
const box: fc.Arbitrary<LabelBox> = fc.record({
  x: along(SHEET.width),
  y: along(SHEET.height),
  width: fc.double({ min: 0, max: 90, noNaN: true }),
  height: fc.double({ min: 0, max: 60, noNaN: true }),
});

test("the grid counts the same places as a full search", () => {
  fc.assert(
    fc.property(fc.array(place, { maxLength: 80 }), fc.array(box, { minLength: 1, maxLength: 20 }), (places, boxes) => {
      const count = placesOn(SHEET, places);
      for (const b of boxes)
        expect(count(b)).toBe(
          places.filter((p) => p.x > b.x && p.x < b.x + b.width && p.y > b.y && p.y < b.y + b.height).length,
        );
    }),
  );
});

test("a box is taken if it overlaps any box on the sheet", () => {
  fc.assert(
    fc.property(fc.array(box, { maxLength: 20 }), fc.array(box, { minLength: 1, maxLength: 20 }), (standing, boxes) => {
      const taken = gridOn(SHEET, (each: LabelBox) => each);
      standing.forEach(taken.put);
      for (const b of boxes)
        expect(taken.some(b, (each) => labelsOverlap(each, b))).toBe(standing.some((s) => labelsOverlap(s, b)));
    }),
  );
});
