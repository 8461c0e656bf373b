import { expect, test, vi } from "vitest";
import { heldTime, manualClock } from "./clock.ts";

test("manual time stands still and advances frame by frame", () => {
  const clock = manualClock();
  const seen: number[] = [];
  const look = (now: number) => {
    seen.push(now);
    clock.frame(look);
  };
  clock.frame(look);
  expect(clock.now()).toBe(0);
  clock.advance(40);
  expect(seen).toEqual([16, 32, 40]);
  expect(clock.now()).toBe(40);
});

test("a cancelled frame is not called, and time never runs backwards", () => {
  const clock = manualClock();
  let seen = 0;
  clock.frame(() => (seen += 1))();
  clock.advance(-5);
  clock.advance(100);
  expect(seen).toBe(0);
  expect(clock.now()).toBe(100);
});

test.each([
  ["", null],
  ["?seed=3", null],
  ["?clock=later", null],
  ["?clock=manual", new Date(2026, 0, 1, 8, 0).getTime()],
  ["?seed=3&clock=2026-11-21T08:05", new Date(2026, 10, 21, 8, 5).getTime()],
  ["?clock=2026-03-07", new Date(2026, 2, 7).getTime()],
])("manual time starts at the moment that %j names, in local time", (search, moment) =>
  expect(heldTime(search)).toBe(moment),
);

test("with a manual clock the time of day advances with the frames, and pauses still use real time", async () => {
  vi.stubGlobal("location", { search: "?clock=2026-11-21T08:05" });
  vi.stubGlobal("window", {});
  vi.resetModules();
  const held = await import("./clock.ts");
  const begin = new Date(2026, 10, 21, 8, 5).getTime();
  expect(held.time()).toBe(begin);
  window.__turnwiseClock?.advance(61_007);
  expect(held.time()).toBe(begin + 61_007);
  expect(held.clock.now()).toBe(61_007);
  expect(held.stopwatch()).not.toBe(61_007);
  vi.unstubAllGlobals();
});
