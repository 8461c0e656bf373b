import { describe, expect, it } from "vitest";
import { axial, radius } from "../../kernel/units.ts";
import { toScreen, type Camera } from "../camera.ts";
import { withLegiblePoints } from "./legible-points.ts";
import { at } from "../../kernel/geometry/point.ts";

const lead = { points: { PS: { x: 10, y: 30 }, PH: { x: 6, y: 21 }, PA: { x: 3, y: 19 } } };
const camera = (scale: number): Camera => ({ scale, xUp: true, zero: { x: 0, y: 0 } });

describe("points of an approach in the picture of the lathe", () => {
  it("are shown while they are apart, and hidden when zoomed out", () => {
    expect(withLegiblePoints([lead], camera(3))).toEqual([lead]);
    expect(withLegiblePoints([lead], camera(1))).toEqual([]);
  });

  it("may fall together: points with one place share their name", () => {
    const same = { points: { PS: { x: 6, y: 21 }, PH: { x: 6, y: 21 }, PA: { x: 3, y: 19 } } };
    expect(withLegiblePoints([same], camera(3))).toEqual([same]);
  });

  it("lie with Z to the right and X upwards", () => {
    const [low, high] = [toScreen(camera(1), at(0, 0)), toScreen(camera(1), { z: axial(5), r: radius(5) })];
    expect([high.x > low.x, high.y < low.y]).toEqual([true, true]);
  });
});
