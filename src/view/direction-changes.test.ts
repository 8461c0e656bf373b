import { expect, test } from "vitest";
import { directionChanges } from "./direction-changes.ts";
import { trackOf } from "./playback.ts";

const seconds = [1.37, 0, 0.002, 4.21, 0.83];
const track = trackOf(seconds.map((each) => ({ seconds: each })));
const changeTimes = (between: readonly [number, number], fine: number, round: readonly number[] = []) =>
  directionChanges(track, between, fine, (step) => round.includes(step));

test("the direction changes where a move ends, and the next stretch starts where the next move begins", () => {
  const bends = changeTimes([0.5, 6], 0.01);
  expect(bends.map(({ seconds: s }) => s.toFixed(3))).toEqual(["1.370", "5.582"]);
  // The second move takes no time: the tip is somewhere else at once.
  expect(bends[0]).toMatchObject({ to: { step: 0, fraction: 1 }, from: { step: 2, fraction: 0 } });
  expect(bends[1]?.to).toEqual({ step: 3, fraction: 1 });
});

test("direction changes lie inside the interval, no closer together than the resolution", () => {
  expect(changeTimes([1.4, 5.5], 0.01)).toEqual([]);
  expect(changeTimes([0, 6.4], 0.0015).map(({ seconds: s }) => s.toFixed(3))).toEqual(["1.370", "1.372", "5.582"]);
  for (const fine of [0.013, 0.31, 2.7]) {
    const bends = changeTimes([0.2, 6.1], fine, [0, 3]);
    const all = [0.2, ...bends.map((b) => b.seconds)];
    expect(bends.length).toBeGreaterThan(0);
    for (let i = 1; i < all.length; i += 1) expect((all[i] ?? 0) - (all[i - 1] ?? 0)).toBeGreaterThan(fine * 0.999);
    expect(all.at(-1)).toBeLessThan(6.1);
  }
});

test("an arc changes direction all along", () => {
  const bends = changeTimes([1.5, 5.5], 0.37, [3]);
  expect(bends).toHaveLength(10);
  for (const { seconds: s, from } of bends)
    expect(from).toMatchObject({ step: 3, fraction: expect.closeTo((s - 1.372) / 4.21, 9) as number });
});
