import { describe, expect, test } from "vitest";
import type { MillMotion } from "../../kernel/plane/mill-motion.ts";
import { at } from "../../kernel/geometry/point.ts";
import { motionAt, type NamedLead } from "./plane-pick.ts";
import { changedPlaneBox } from "./changed-box.ts";

const motion = (
  from: readonly [number, number],
  to: readonly [number, number],
  index: number,
  feed?: number,
): MillMotion => ({
  kind: feed === undefined ? "rapid" : "feed",
  from: { x: from[0], y: from[1], z: -3 },
  to: { x: to[0], y: to[1], z: -3 },
  ...(feed !== undefined && { feed }),
  radius: 4.5,
  index,
});
const motions = [
  motion([-20, -11], [-8.5, -11], 3),
  motion([-8.5, -11], [-8.5, 6.4], 4, 900),
  motion([-8.5, 6.4], [-8.5, 61.3], 5, 300),
  { ...motion([-8.5, 61.3], [21.7, 61.3], 6, 300), kind: "arc", centre: { x: 6.6, y: 61.3 }, turn: "cw" } as const,
];
const leads: readonly NamedLead[] = [{ index: 4, points: { PS: { x: -8.5, y: -11 }, PA: { x: -8.5, y: 6.4 } } }];

describe("pointing in the working plane", () => {
  test("picks the nearest motion and its moment there", () => {
    expect(motionAt(motions, [], at(-9.1, 20), 2)).toEqual({
      step: 2,
      fraction: expect.closeTo((20 - 6.4) / 54.9, 6) as number,
    });
    expect(motionAt(motions, [], at(6.4, 76.1), 2)).toMatchObject({
      step: 3,
      fraction: expect.closeTo(0.5, 1) as number,
    });
    expect(motionAt(motions, [], at(6.6, 61.3), 2)).toBeNull();
  });
  test("picks the approach of a named point, though the contour begins there too", () => {
    expect(motionAt(motions, [], at(-8.9, 6.9), 2)?.step).toBe(2);
    expect(motionAt(motions, leads, at(-8.9, 6.9), 2)).toEqual({ step: 1, fraction: expect.closeTo(1, 2) as number });
    expect(motionAt(motions, leads, at(-8.9, 9.1), 2)?.step).toBe(2);
  });
});

describe("the box in which the stock of two moments differs", () => {
  test("covers the tool path between them, and the whole of a motion that ended", () => {
    expect(changedPlaneBox(motions, { step: 0, fraction: 0.25 }, { step: 0, fraction: 0.75 })).toEqual({
      left: -20 + 11.5 / 4 - 4.5,
      right: -8.5 - 11.5 / 4 + 4.5,
      low: -15.5,
      high: -6.5,
    });
    const both = changedPlaneBox(motions, { step: 1, fraction: 0.5 }, { step: 0, fraction: 0.75 });
    expect(both).toEqual({
      left: -24.5,
      right: -4,
      low: -15.5,
      high: expect.closeTo(-11 + 17.4 / 2 + 4.5, 9) as number,
    });
  });
  test("is null when no time passes, and everything when too much does", () => {
    expect(changedPlaneBox(motions, { step: 4, fraction: 0 }, { step: 4, fraction: 0 })).toBeNull();
    expect(changedPlaneBox(motions, { step: 0, fraction: 0 }, { step: 999, fraction: 0 })).toBe("all");
  });
});
