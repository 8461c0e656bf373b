import { expect, test } from "vitest";
import { answerOf } from "../../src/course/judge/answer.ts";
import { plannedPart } from "../../src/planning/part/planned-part.ts";
import { partByHand, programByHand, PROGRAMMED_BY_HAND } from "./by-hand.ts";

test.each(PROGRAMMED_BY_HAND)("$name is a part, programmed by hand in $seconds s", (made) => {
  const { totalSeconds } = answerOf(programByHand(made)).simulation;
  expect(Math.abs(totalSeconds - made.seconds)).toBeLessThan(0.1);
  const { part, problems } = plannedPart(partByHand(made));
  expect(problems.filter((p) => p.severity === "error")).toEqual([]);
  expect(part?.rings.length).toBeGreaterThan(0);
});
