import { expect, test } from "vitest";
import type { ThreadPlan } from "../kernel/plan/plan.ts";
import { at } from "../kernel/geometry/point.ts";
import { length } from "../kernel/units.ts";
import { threadProfile } from "./thread-profile.ts";

const tan = Math.tan(Math.PI / 6);
const thread: ThreadPlan = {
  pitch: length(2.3),
  lead: length(2.3),
  starts: 1,
  depths: [0.7, 0.99, 1.21, 1.4].map(length),
  slope: Math.tan((29 * Math.PI) / 180),
  out: at(0, 1),
  above: [],
  crest: [],
  end: at(0, 0),
  runIn: length(5),
  side: [
    { u: -5 * tan, v: 5 },
    { u: 0, v: 0 },
    { u: 5 * tan, v: 5 },
  ],
};
const areaOf = (points: readonly { x: number; y: number }[]) =>
  Math.abs(
    points.reduce((sum, p, i) => {
      const q = points[(i + 1) % points.length] ?? p;
      return sum + p.x * q.y - q.x * p.y;
    }, 0),
  ) / 2;

test("the chips of all passes together are the groove, and with a constant cross-section all chips are of equal size", () => {
  const drawing = threadProfile(thread, 300, 200);
  const chips = drawing?.chips ?? [];
  expect(chips.map((c) => c.pass)).toEqual([1, 2, 3, 4]);
  const areas = chips.map((c) => areaOf(c.points));
  const whole = areas.reduce((a, b) => a + b, 0);
  const high = Math.max(...chips.flatMap((c) => c.points.map((p) => p.y))) - (drawing?.crest ?? 0);
  expect(whole / (high * high * tan)).toBeGreaterThan(0.97);
  expect(whole / (high * high * tan)).toBeLessThan(1.03);
  for (const area of areas) expect(area / (whole / 4)).toBeCloseTo(1, 1);
});

test("everything stays inside the drawing, and there is none without a pass", () => {
  for (const { points } of threadProfile(thread, 120, 60)?.chips ?? [])
    for (const { x, y } of points) expect([x >= 0 && x <= 120, y >= 0 && y <= 60]).toEqual([true, true]);
  expect(threadProfile({ ...thread, depths: [] }, 120, 60)).toBeNull();
});

test("hundreds of passes are drawn as a few", () => {
  const depths = Array.from({ length: 400 }, (_, i) => length((1.4 * (i + 1)) / 400));
  const chips = threadProfile({ ...thread, depths }, 300, 200)?.chips ?? [];
  expect(chips.length).toBeLessThanOrEqual(40);
  expect(chips.at(-1)?.pass).toBe(400);
});
