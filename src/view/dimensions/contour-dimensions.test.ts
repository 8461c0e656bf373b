import fc from "fast-check";
import { expect, test } from "vitest";
import { part } from "../../kernel/geometry/point.ts";
import { fitted, toScreen } from "../camera.ts";
import { labelsOverlap } from "./labels.ts";
import { placedDimensions, type DimensionPaper, type DimensionRequest } from "./placed-dimensions.ts";

const size = { width: 713, height: 431 };
const MOUSE = { width: 40, height: 22 };
const sheet: DimensionPaper = {
  size,
  camera: fitted(
    { left: -63.4, right: 3.7, low: 0, high: 31.9 },
    size,
    { left: 60, right: 90, top: 30, bottom: 70 },
    true,
  ),
  unit: 1,
  room: { x: 48, y: 2, width: size.width - 50, height: size.height - 26 },
  target: MOUSE,
  kept: [],
  free: { x: 640, y: 360 },
  avoid: [],
};
const point = (z: number, r: number) => part.point(z, r);
const asked = (
  key: string,
  measured: DimensionRequest["measured"],
  needed = false,
  text = "⌀ 48.5",
): DimensionRequest => ({
  key,
  text,
  measured,
  needed,
});
/** The places that a path goes through. */
const places = (d: string) =>
  [...d.matchAll(/(-?[\d.]+) (-?[\d.]+)/g)].map((m) => ({ x: Number(m[1]), y: Number(m[2]) }));

test("a diameter stands at the right edge at the height of its point, Z under its point above the scale", () => {
  const at = point(-23.617, 8.715),
    screen = toScreen(sheet.camera, at);
  const [x, z] = placedDimensions(sheet, [
    asked("x", { form: "ordinate", of: "diameter", at }),
    asked("z", { form: "ordinate", of: "axial", at }),
  ]);
  expect(x?.box.y).toBeCloseTo(screen.y - 11, 6);
  expect((x?.box.x ?? 0) + (x?.box.width ?? 0)).toBeLessThan(size.width);
  expect(places(x?.lines ?? "")[0]?.y).toBeCloseTo(screen.y, 1);
  expect((z?.box.x ?? 0) + (z?.box.width ?? 0) / 2).toBeCloseTo(screen.x, 6);
  expect((z?.box.y ?? 0) + (z?.box.height ?? 0)).toBeLessThan(size.height - 22);
});

test("on a sheet larger than the contour texts stay near the contour", () => {
  const at = point(-23.617, 8.715);
  const [x, z] = placedDimensions({ ...sheet, free: { x: 500, y: 300 } }, [
    asked("x", { form: "ordinate", of: "diameter", at }),
    asked("z", { form: "ordinate", of: "axial", at }),
  ]);
  expect(x?.box.x).toBe(500);
  expect(z?.box.y).toBe(300);
});

test("two nearly equal diameters are moved apart; without room one is left out, but never one of the chosen element", () => {
  const near = [8.715, 8.9, 9.1, 9.35].map((r, i) =>
    asked(`x${i}`, { form: "ordinate", of: "diameter", at: point(-10, r) }),
  );
  const placed = placedDimensions(sheet, near);
  expect(placed).toHaveLength(4);
  for (const [i, a] of placed.entries())
    for (const b of placed.slice(i + 1)) expect(labelsOverlap(a.box, b.box)).toBe(false);
  const many = Array.from({ length: 40 }, (_, i) =>
    asked(`x${i}`, { form: "ordinate", of: "diameter", at: point(-10, 9 + i / 100) }, i === 39),
  );
  const kept = placedDimensions(sheet, many).map((p) => p.key);
  expect(kept.length).toBeLessThan(40);
  expect(kept[0]).toBe("x39");
});

test("a length runs beside its element with an arrowhead at each end", () => {
  const from = point(-40.3, 12.2),
    to = point(-11.9, 20.7),
    [a, b] = [toScreen(sheet.camera, from), toScreen(sheet.camera, to)];
  const [one] = placedDimensions(sheet, [asked("l", { form: "along", from, to }, true)]);
  const heads = places(one?.arrows ?? "");
  const [tipA, tipB] = [heads[0], heads[3]];
  expect(Math.hypot((tipB?.x ?? 0) - (tipA?.x ?? 0), (tipB?.y ?? 0) - (tipA?.y ?? 0))).toBeCloseTo(
    Math.hypot(b.x - a.x, b.y - a.y),
    0,
  );
});

test("a text moves to the other side rather than cover the contour", () => {
  const from = point(-40.3, 15),
    to = point(-11.9, 15),
    [a] = [toScreen(sheet.camera, point(-26.1, 15))];
  const [up] = placedDimensions(sheet, [asked("l", { form: "along", from, to })]);
  const avoid = Array.from({ length: 30 }, (_, i) => ({ x: a.x - 15 + i, y: a.y - 30 }));
  const [down] = placedDimensions({ ...sheet, avoid }, [asked("l", { form: "along", from, to })]);
  expect(up?.box.y).toBeLessThan(a.y);
  expect(down?.box.y).toBeGreaterThan(a.y);
});

test("a dimension outside the picture is left out unless its element is chosen", () => {
  const far = point(-500, 10);
  expect(placedDimensions(sheet, [asked("far", { form: "ordinate", of: "axial", at: far })])).toEqual([]);
  expect(placedDimensions(sheet, [asked("far", { form: "ordinate", of: "axial", at: far }, true)])).toHaveLength(1);
});

test("every text is fully on the sheet, clear of the scales and of all texts that are not chosen", () => {
  const number = (min: number, max: number) => fc.integer({ min: min * 1000, max: max * 1000 }).map((n) => n / 1000);
  const at = fc.record({ z: number(-60, 3), r: number(0.3, 31) }).map(({ z, r }) => point(z, r));
  const measured = fc.oneof(
    at.map((p): DimensionRequest["measured"] => ({ form: "ordinate", of: "diameter", at: p })),
    at.map((p): DimensionRequest["measured"] => ({ form: "ordinate", of: "axial", at: p })),
    fc.tuple(at, at).map(([from, to]): DimensionRequest["measured"] => ({ form: "along", from, to })),
    fc.tuple(at, number(-179, 179)).map(([p, angle]): DimensionRequest["measured"] => ({
      form: "angle",
      vertex: p,
      from: part.point(p.z + 1, p.r),
      to: part.point(p.z + Math.cos(angle), p.r + Math.sin(angle)),
    })),
    fc.tuple(at, at).map(([from, to]): DimensionRequest["measured"] => ({ form: "leader", at: from, towards: to })),
  );
  fc.assert(
    fc.property(fc.array(measured, { maxLength: 14 }), fc.boolean(), (all, fingers) => {
      const target = fingers ? { width: 56, height: 48 } : MOUSE;
      const placed = placedDimensions(
        { ...sheet, target },
        all.map((m, i) => asked(String(i), m)),
      );
      for (const [i, { box }] of placed.entries()) {
        expect(box.x).toBeGreaterThanOrEqual(46);
        expect(box.y).toBeGreaterThanOrEqual(0);
        expect(box.x + box.width).toBeLessThanOrEqual(size.width);
        expect(box.y + box.height).toBeLessThanOrEqual(size.height - 22);
        for (const other of placed.slice(i + 1)) expect(labelsOverlap(box, other.box)).toBe(false);
      }
    }),
    { numRuns: 150 },
  );
});
