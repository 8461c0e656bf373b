import { expect, test } from "vitest";
import { clampingBodies, type Clamping } from "../../kernel/area/clamping.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { at } from "../../kernel/geometry/point.ts";
import { clampingNear } from "./clamping-on-paper.ts";

const blank = [[at(-100, 0), at(0, 0), at(0, 30), at(-100, 30)]],
  bounds = { left: -100, right: 0, low: 0, high: 30 };
const near = (clamping: Clamping) => clampingNear({ clamping, bodies: clampingBodies(clamping, blank) }, bounds);

test("a chuck that is cut off near the work has no edge where it goes on", () => {
  const { areas, edges } = near({ kind: "chuckOutside", diameter: 60, length: 25, face: -75, size: 200 });
  expect(boxAround(areas)).toMatchObject({ left: -115, high: 60, right: -75 });
  const level = edges.filter(([p, q]) => p.r === q.r).map(([p]) => p.r),
    upright = edges.filter(([p, q]) => p.z === q.z).map(([p]) => p.z);
  expect(level).toContain(30);
  expect(level).not.toContain(60);
  expect(upright).toContain(-75);
  expect(upright).not.toContain(-115);
});

test("a centre in front of the work has no edge on the axis, nor where it is cut off", () => {
  const { edges } = near({
    kind: "centres",
    diameter: 20,
    length: 0,
    face: -100,
    tailstock: { quill: 40, tip: -2, angle: 60 },
  });
  const front = edges.filter(([p, q]) => Math.max(p.z, q.z) > -50);
  expect(front.length).toBeGreaterThan(0);
  for (const [p, q] of front) expect([p.r + q.r > 0, Math.min(p.z, q.z) < 15]).toEqual([true, true]);
});
