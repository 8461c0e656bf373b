import { expect, test } from "vitest";
import { createSharpness } from "./sharpness.ts";

/** The shares after so many pictures, each of which takes what the share that is in force says. */
function shares(took: (share: number) => number, pictures: number): number[] {
  const sharpness = createSharpness(),
    out: number[] = [];
  let share = 1;
  for (let i = 0; i < pictures; i += 1) {
    share = sharpness.took(took(share));
    if (out.at(-1) !== share) out.push(share);
  }
  return out;
}

test("pictures that come late are drawn with fewer pixels as long as that brings them sooner", () => {
  const seen = shares((share) => 7 + 61.3 * share * share, 400);
  expect(seen).toEqual([1, 0.7]);
  // Late at any number of pixels, but each step is worth it: down to the fewest.
  expect(shares((share) => 31 + 173 * share * share, 400).at(-1)).toBeLessThan(0.5);
});

test("where something else is slow pixels are given back and kept", () => {
  const seen = shares((share) => 117 + 3.1 * share, 900);
  expect(seen).toEqual([1, 0.7, 1]);
});

test("pictures that come soon again are sharp again, and late ones are tried again", () => {
  const sharpness = createSharpness();
  for (let i = 0; i < 6; i += 1) sharpness.took(55);
  expect(sharpness.took(11)).toBe(0.7);
  for (let i = 0; i < 200; i += 1) sharpness.took(11);
  expect(sharpness.took(11)).toBe(1);
  for (let i = 0; i < 6; i += 1) sharpness.took(55);
  expect(sharpness.took(11)).toBe(0.7);
});

test("a single late picture, and one that waited for the work of another part, change nothing", () => {
  expect(shares((share) => (share === 1 ? 16.7 : 0), 300)).toEqual([1]);
  const sharpness = createSharpness();
  expect([sharpness.took(97), sharpness.took(12), sharpness.took(97), sharpness.took(12)]).toEqual([1, 1, 1, 1]);
});
