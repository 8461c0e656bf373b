import { expect, test } from "vitest";
import { clampingBodies, type Clamping } from "../../kernel/area/clamping.ts";
import { at } from "../../kernel/geometry/point.ts";
import { chuckDrawing } from "./chuck.ts";
import { breakWave } from "./break-outline.ts";

const blank = [[at(-73.4, 0), at(1.2, 0), at(1.2, 31.7), at(-73.4, 31.7)]],
  material = { left: -73.4, right: 1.2, low: 0, high: 31.7 };
const clamping: Clamping = { kind: "chuckOutside", diameter: 63.4, length: 21, face: -52.4, size: 200 };
const stated = { clamping, bodies: clampingBodies(clamping, blank) };
const chuck = chuckDrawing(blank, material, stated);

test("without a stated clamping there is a plane at the rear end, and nothing that looks like a chuck", () => {
  const { unstated, turned, jaws, flanks, backs, all } = chuckDrawing(blank, material, null);
  expect(unstated?.plane).toEqual([at(-73.4, 0), at(-73.4, 31.7)]);
  for (const [from, to] of unstated?.hatch ?? []) expect([from.z, to.z < from.z]).toEqual([-73.4, true]);
  expect([turned, jaws, flanks, backs]).toEqual([[], [], [], []]);
  expect(all.left).toBeGreaterThan(-73.4 - 12.1);
});

test("the plane of a tube begins at its bore", () => {
  const tube = [[at(-10, 4), at(0, 4), at(0, 9), at(-10, 9)]];
  const { unstated } = chuckDrawing(tube, { left: -10, right: 0, low: 4, high: 9 }, null);
  expect(unstated?.plane).toEqual([at(-10, 4), at(-10, 9)]);
});

test("the plane of a blank of any size has a number of lines that can be drawn", () => {
  for (const r of [0.01, 300, 5e7]) {
    const bar = [[at(-10, 0), at(0, 0), at(0, r), at(-10, r)]];
    const { unstated, all } = chuckDrawing(bar, { left: -10, right: 0, low: 0, high: r }, null);
    expect(unstated?.hatch.length).toBeLessThanOrEqual(60);
    // They stay short, so that the picture is of the blank.
    expect(all.left).toBeGreaterThan(-40);
  }
});

test("a stated clamping is drawn where collisions are checked", () => {
  expect(chuck.unstated).toBeNull();
  const drawn = (part: string) =>
    stated.bodies.filter((b) => b.part === part).flatMap(({ rings }) => rings.map((r) => r.map((p) => [p.z, p.r])));
  expect(chuck.jaws).toEqual(drawn("jaws"));
  expect(chuck.turned).toEqual(drawn("chuck"));
  expect(chuck.seen.left).toBeLessThan(-73.4);
});

test("the jaw facing the viewer is a third of a turn on: on the other side, half as far out", () => {
  const middle = (points: readonly (readonly [number, number])[]) =>
    points.reduce((sum, [, r]) => sum + r, 0) / points.length;
  const outer = Math.max(...chuck.jaws.flat().map(([, r]) => r));
  expect(Math.min(...chuck.backs.map(middle))).toBeCloseTo(-0.5 * outer, 6);
  expect(chuck.backs).toHaveLength(3);
  expect(chuck.flanks.map(middle).every((r) => r < 0)).toBe(true);
});

test("a limit is a line and no body", () => {
  const limited = { ...clamping, limit: { z: -50, x: 40 } };
  const made = chuckDrawing(blank, material, { clamping: limited, bodies: clampingBodies(limited, blank) });
  expect(made.limit).toEqual({ z: -50, r: 20 });
  expect(made.turned).toEqual(chuck.turned);
});

test("break lines cut the clamping off near the blank, and beyond every contact with the tool", () => {
  const widest = Math.max(...chuck.turned.flat().map(([, r]) => r));
  expect(chuck.cut).toEqual(chuck.seen);
  expect(chuck.all.high).toBeLessThan(widest / 2);
  expect(chuck.all.high).toBeGreaterThan(1.2 * material.high);
  const contact = { left: -66.1, right: -63.9, low: 82.3, high: 84.7 };
  const { cut, all, seen } = chuckDrawing(blank, material, stated, contact);
  expect(cut?.high).toBeGreaterThan(contact.high);
  expect(all.high).toBeGreaterThan(contact.high);
  // The picture still frames the work.
  expect(seen).toEqual(chuck.seen);
});

test("a break line begins at its place, bends to one side only and does not move with its end", () => {
  const line = breakWave({ x: 12.5, y: 40 }, { x: 312.5, y: 40 });
  expect(line[0]).toEqual({ x: 12.5, y: 40 });
  const off = line.map(({ y }) => y - 40);
  expect(Math.min(...off)).toBeGreaterThanOrEqual(0);
  expect(Math.max(...off)).toBeGreaterThan(3);
  expect(Math.max(...off)).toBeLessThanOrEqual(4.001);
  expect(breakWave({ x: 12.5, y: 40 }, { x: 212.5, y: 40 })).toEqual(line.slice(0, 67));
});
