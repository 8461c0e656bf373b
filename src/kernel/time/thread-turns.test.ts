import { expect, test } from "vitest";
import { at } from "../geometry/point.ts";
import { handOf, type ThreadMove } from "./thread-turns.ts";
import { degrees, length } from "../units.ts";

const THREAD = {
  kind: "thread",
  pitch: length(1.75),
  axis: "z",
  angle: degrees(17),
  stops: false,
  phase: "thread",
  run: "rough",
  step: 2,
} as const;
const to = (z: number): ThreadMove => ({ ...THREAD, to: at(z, 14.3) });

test("a feed to the chuck with the spindle forwards cuts a right-handed thread; reversing either reverses the hand", () => {
  const from = at(-3.7, 14.3);
  expect([to(-21.9), to(8.4)].map((move) => [handOf(from, move, false), handOf(from, move, true)])).toEqual([
    [1, -1],
    [-1, 1],
  ]);
});
