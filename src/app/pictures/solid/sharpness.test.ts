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

test("late frames lower the resolution as long as that makes them faster", () => {
  const seen = shares((share) => 7 + 61.3 * share * share, 400);
  expect(seen).toEqual([1, 0.7]);
  // Late at any resolution, but each step is worth it: down to the lowest.
  expect(shares((share) => 31 + 173 * share * share, 400).at(-1)).toBeLessThan(0.5);
});

test("if something else is slow the resolution is restored and kept", () => {
  const seen = shares((share) => 117 + 3.1 * share, 900);
  expect(seen).toEqual([1, 0.7, 1]);
});

test("fast frames restore the resolution, and late ones lower it again", () => {
  const sharpness = createSharpness();
  for (let i = 0; i < 6; i += 1) sharpness.noteFrame(55);
  expect(sharpness.noteFrame(11)).toBe(0.7);
  for (let i = 0; i < 200; i += 1) sharpness.noteFrame(11);
  expect(sharpness.noteFrame(11)).toBe(1);
  for (let i = 0; i < 6; i += 1) sharpness.noteFrame(55);
  expect(sharpness.noteFrame(11)).toBe(0.7);
});

test("a single late frame, and one that waited for other work, change nothing", () => {
  expect(shares((share) => (share === 1 ? 16.7 : 0), 300)).toEqual([1]);
  const sharpness = createSharpness();
  expect([sharpness.noteFrame(97), sharpness.noteFrame(12), sharpness.noteFrame(97), sharpness.noteFrame(12)]).toEqual([
    1, 1, 1, 1,
  ]);
});
