import { expect, test } from "vitest";
import { manualClock } from "../../base/clock.ts";
import { createEye } from "./eye.ts";

const BOUNDS = { left: -61.3, right: 1.7, low: 0, high: 22.9 };

function opened(still = false) {
  const clock = manualClock(),
    eye = createEye(clock, () => still);
  eye.setSize({ width: 640, height: 407 });
  eye.setBounds(BOUNDS);
  return { clock, eye };
}
const TURN = 0.173;

test("choosing a view and turning it before it is reached gives both", () => {
  const { clock, eye } = opened(),
    wanted = opened(true).eye;
  wanted.go("front");
  wanted.turn(TURN, 0);
  eye.go("front");
  clock.advance(48);
  eye.turn(TURN, 0);
  expect(eye.get()).toEqual(wanted.get());
  clock.advance(500);
  expect(eye.get()).toEqual(wanted.get());
});

test("after that a hand continues from the visible view", () => {
  const { clock, eye } = opened();
  eye.go("end");
  clock.advance(500);
  const there = eye.get();
  eye.turn(TURN, 0);
  eye.turn(TURN, 0);
  expect(eye.get().turn).toBeCloseTo(there.turn + 2 * TURN, 9);
});

test("with reduced motion a view changes at once", () => {
  const { clock, eye } = opened(true);
  eye.go("end");
  const there = eye.get();
  expect(there.turn).toBeCloseTo(Math.PI / 2, 9);
  clock.advance(500);
  expect(eye.get()).toBe(there);
});

test("lines without a body fill the view", () => {
  const { eye } = opened(true),
    round = eye.get();
  eye.setBounds({ ...BOUNDS, low: 13.1 }, true);
  expect(eye.get().distance).toBeLessThan(round.distance);
  expect(eye.get().centre[0]).toBeGreaterThan(round.centre[0]);
});
