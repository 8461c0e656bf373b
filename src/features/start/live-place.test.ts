import { expect, test } from "vitest";
import { durationOf, livePlace, END_PAUSE } from "./live-place.ts";
import type { LiveRun } from "./pictures.ts";

const run = {
  way: [
    [0, 2, 37.5, 0, 0],
    [130, 2, 33.1, 0, 0],
    [930, -41.3, 33.1, 1, 1],
    [1030, -41.3, 38, 1, 0],
  ],
} as unknown as LiveRun;

test("between two waypoints the tool is interpolated, with the stock before and after the move", () => {
  expect(livePlace(run, 530)).toEqual({
    z: expect.closeTo(-19.65, 6) as number,
    r: 33.1,
    inwards: true,
    before: 0,
    after: 1,
    pass: 1,
  });
  expect(livePlace(run, 65)).toMatchObject({
    z: 2,
    r: expect.closeTo(35.3, 6) as number,
    before: 0,
    after: 0,
    pass: 0,
  });
});

test("it starts at the first place and stays at the last one", () => {
  expect(livePlace(run, 0)).toMatchObject({ z: 2, r: 37.5, after: 0 });
  expect(livePlace(run, 1030 + END_PAUSE - 1)).toMatchObject({ z: -41.3, r: 38, before: 1, after: 1 });
  expect(durationOf(run)).toBe(1030 + END_PAUSE);
});
