import { expect, test } from "vitest";
import { chuckRings } from "../chuck.ts";
import { chuckDrawing, serration, SERRATION } from "./chuck.ts";

const blank = { left: -73.4, right: 1.2, low: 0, high: 31.7 }, busy = { left: -41.9, right: 7, low: 3, high: 36 };
const chuck = chuckDrawing(blank, busy);

test("the jaw grips what the plain chuck grips, and no more", () => {
  const tip = Math.max(...chuckRings(blank, busy).jaw.map((p) => p.z));
  const beyond = chuck.jaw.filter(([z]) => z > blank.left);
  expect(Math.max(...chuck.jaw.map(([z]) => z))).toBeCloseTo(tip, 9);
  for (const [, r] of beyond) expect(r).toBeGreaterThanOrEqual(blank.high);
  expect(tip).toBeLessThan(busy.left);
});

test("three steps go down outwards, on a body that carries all of the jaw", () => {
  const heights = [...new Set(chuck.jaw.slice(3, -1).map(([z]) => z))];
  expect(heights).toHaveLength(3);
  expect(heights).toEqual([...heights].sort((a, b) => b - a));
  expect(Math.max(...chuck.jaw.map(([, r]) => r))).toBeLessThan(chuck.body.radius);
  expect(chuck.body.face).toBeLessThan(blank.left);
  expect(chuck.bolts).toBeLessThan(chuck.body.radius);
});

test("the jaw to the viewer is a third of a turn on: on the other side, half as far out", () => {
  const middle = (points: readonly (readonly [number, number])[]) => points.reduce((sum, [, r]) => sum + r, 0) / points.length;
  for (const [i, back] of chuck.backs.entries()) {
    const out = chuck.jaw[4 + 2 * i]?.[1] ?? NaN;
    expect(middle(back)).toBeCloseTo(-0.5 * out, 6);
  }
  for (const [, r] of chuck.flank) expect(r).toBeLessThan(0);
});

test("teeth of the serration are whole and about as long as real ones", () => {
  const teeth = serration(chuck.joint), points = teeth.filter(([z]) => z > chuck.joint.z);
  expect((chuck.joint.to - chuck.joint.from) / points.length).toBeCloseTo(SERRATION, 1);
  expect([teeth[0]?.[1], teeth.at(-1)?.[1]]).toEqual([chuck.joint.from, chuck.joint.to]);
});
