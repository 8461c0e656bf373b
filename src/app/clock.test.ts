import { expect, test } from "vitest";
import { manualClock } from "./clock.ts";

test("held time stands still and moves picture by picture", () => {
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

test("a cancelled picture does not come, and time never runs back", () => {
  const clock = manualClock();
  let seen = 0;
  clock.frame(() => (seen += 1))();
  clock.advance(-5);
  clock.advance(100);
  expect(seen).toBe(0);
  expect(clock.now()).toBe(100);
});
