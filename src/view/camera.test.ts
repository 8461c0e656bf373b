import fc from "fast-check";
import { expect, test } from "vitest";
import { axial, radius } from "../kernel/units.ts";
import {
  fitted,
  matrix,
  panned,
  pinched,
  SCALE,
  seenFrom,
  sheetShift,
  toPlace,
  toScreen,
  turnedOver,
  zoomed,
  type Camera,
} from "./camera.ts";

const number = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const place = fc.record({ x: number(0, 2000), y: number(0, 2000) });
const camera: fc.Arbitrary<Camera> = fc.record({
  scale: number(0.1, 500),
  zero: fc.record({ x: number(-5000, 5000), y: number(-5000, 5000) }),
  xUp: fc.boolean(),
});
const point = fc.record({ z: number(-500, 500).map(axial), r: number(-300, 300).map(radius) });
const near = (a: number, b: number) => expect(Math.abs(a - b)).toBeLessThan(1e-6);

test("part → screen → part is the same place, with X up and with X down", () => {
  fc.assert(
    fc.property(camera, point, (c, p) => {
      const back = toPlace(c, toScreen(c, p));
      near(back.z, p.z);
      near(back.r, p.r);
    }),
  );
});

test("Z runs to the right, X the way the switch says", () => {
  fc.assert(
    fc.property(camera, point, (c, p) => {
      const here = toScreen(c, p),
        there = toScreen(c, { z: axial(p.z + 1), r: radius(p.r + 1) });
      expect(there.x).toBeGreaterThan(here.x);
      expect(there.y < here.y).toBe(c.xUp);
    }),
  );
});

test("zooming keeps the point under the pointer", () => {
  fc.assert(
    fc.property(camera, place, number(0.2, 5), (c, at, factor) => {
      const before = toPlace(c, at),
        after = toPlace(zoomed(c, factor, at), at);
      near(after.z, before.z);
      near(after.r, before.r);
    }),
  );
});

test("panning there and back is no change", () => {
  fc.assert(
    fc.property(camera, number(-500, 500), number(-500, 500), (c, dx, dy) => {
      const back = panned(panned(c, dx, dy), -dx, -dy);
      near(back.zero.x, c.zero.x);
      near(back.zero.y, c.zero.y);
    }),
  );
});

test("pinching moves the points under the fingers along", () => {
  fc.assert(
    fc.property(camera, place, place, number(-100, 100), (c, a, b, shift) => {
      fc.pre(Math.hypot(a.x - b.x, a.y - b.y) > 20);
      const moved = pinched(
        c,
        [a, b],
        [
          { x: a.x + shift, y: a.y },
          { x: b.x + shift, y: b.y },
        ],
      );
      const before = toPlace(c, a),
        after = toPlace(moved, { x: a.x + shift, y: a.y });
      near(after.z, before.z);
      near(after.r, before.r);
    }),
  );
});

test("a fitted picture shows all corners of its box", () => {
  fc.assert(
    fc.property(
      number(-200, 0),
      number(1, 300),
      number(-50, 50),
      number(1, 200),
      fc.boolean(),
      (left, wide, low, tall, xUp) => {
        const size = { width: 640, height: 420 },
          margin = { left: 50, right: 10, top: 20, bottom: 30 };
        const c = fitted({ left, right: left + wide, low, high: low + tall }, size, margin, xUp);
        for (const z of [left, left + wide]) {
          for (const r of [low, low + tall]) {
            const at = toScreen(c, { z: axial(z), r: radius(r) });
            expect(at.x).toBeGreaterThan(49.9);
            expect(at.x).toBeLessThan(630.1);
            expect(at.y).toBeGreaterThan(19.9);
            expect(at.y).toBeLessThan(390.1);
          }
        }
      },
    ),
  );
});

test("turning the picture over twice is no change", () => {
  fc.assert(
    fc.property(camera, (c) => {
      const size = { width: 640, height: 420 },
        back = turnedOver(turnedOver(c, size), size);
      expect(back.xUp).toBe(c.xUp);
      near(back.zero.y, c.zero.y);
    }),
  );
});

test("no zoom leaves the useful range, and then the place under the pointer still stays", () => {
  fc.assert(
    fc.property(camera, place, number(1e-6, 1e6), (c, at, factor) => {
      const now = zoomed(c, factor, at);
      expect(now.scale).toBe(Math.min(SCALE.max, Math.max(SCALE.min, c.scale * factor)));
      near(toPlace(now, at).z, toPlace(c, at).z);
    }),
  );
});

test("a drawing for one camera lies under another where that camera shows it", () => {
  const size = { width: 640, height: 400 };
  fc.assert(
    fc.property(camera, camera, point, (drawn, other, p) => {
      const now = { ...other, xUp: drawn.xUp };
      const { x, y, grown } = sheetShift(drawn, now);
      const [on, wanted] = [toScreen(drawn, p), toScreen(now, p)];
      const far = Math.max(1, Math.abs(wanted.x), Math.abs(wanted.y), Math.abs(on.x * grown), Math.abs(on.y * grown));
      expect(Math.abs(x + on.x * grown - wanted.x) / far).toBeLessThan(1e-9);
      expect(Math.abs(y + on.y * grown - wanted.y) / far).toBeLessThan(1e-9);
      // The corners of the picture, back in the drawing.
      const { from, to } = seenFrom(drawn, now, size);
      for (const [corner, seen] of [
        [{ x: 0, y: 0 }, from],
        [{ x: size.width, y: size.height }, to],
      ] as const) {
        const there = toPlace(drawn, seen),
          here = toPlace(now, corner);
        expect(Math.abs(there.z - here.z)).toBeLessThan(1e-6 * Math.max(1, Math.abs(here.z)));
        expect(Math.abs(there.r - here.r)).toBeLessThan(1e-6 * Math.max(1, Math.abs(here.r)));
      }
      const [a, b, c, d, e, f] = matrix(drawn);
      near(a * p.z + c * p.r + e, on.x);
      near(b * p.z + d * p.r + f, on.y);
    }),
  );
});
