import { expect, test } from "vitest";
import { createSharpness } from "./sharpness.ts";

/** The shares after a number of frames, each of which takes the time that `took` gives for the share in force. */
function shares(took: (share: number) => number, pictures: number): number[] {
  const sharpness = createSharpness(),
    out: number[] = [];
  let share = 1;
  for (let i = 0; i < pictures; i += 1) {
    share = sharpness.noteFrame(took(share));
    if (out.at(-1) !== share) out.push(share);
  }
  return out;
}

test("late frames lower the resolution to what it takes", () => {
  const seen = shares((share) => 7 + 61.3 * share * share, 400);
  expect(seen).toHaveLength(2);
  expect(seen[1]).toBeCloseTo(0.66, 2);
  // Late at any resolution, but the lowest is worth it.
  expect(shares((share) => 31 + 173 * share * share, 400)).toEqual([1, 0.5, 0.4]);
});

test("if something else is slow the resolution is restored and kept", () => {
  const seen = shares((share) => 117 + 3.1 * share, 900);
  expect(seen).toEqual([1, 0.5, 0.4, 1]);
});

test("fast frames restore the resolution, and late ones lower it again", () => {
  const sharpness = createSharpness();
  for (let i = 0; i < 3; i += 1) sharpness.noteFrame(120);
  expect(sharpness.noteFrame(11)).toBe(0.5);
  for (let i = 0; i < 300; i += 1) sharpness.noteFrame(11);
  expect(sharpness.noteFrame(11)).toBe(1);
  for (let i = 0; i < 3; i += 1) sharpness.noteFrame(120);
  expect(sharpness.noteFrame(11)).toBe(0.5);
});

test("one frame that waits very long for other work does not undo the lowest resolution", () => {
  let frames = 0;
  expect(shares((share) => ((frames += 1) === 60 ? 1600 : 31 + 173 * share * share), 400)).toEqual([1, 0.5, 0.4]);
});

test("a single late frame, and one that waited for other work, change nothing", () => {
  expect(shares((share) => (share === 1 ? 16.7 : 0), 300)).toEqual([1]);
  const sharpness = createSharpness();
  expect([sharpness.noteFrame(97), sharpness.noteFrame(12), sharpness.noteFrame(97), sharpness.noteFrame(12)]).toEqual([
    1, 1, 1, 1,
  ]);
});
