import { expect, test } from "vitest";
import { answerOf } from "../../src/course/judge/answer.ts";
import { plannedPart } from "../../src/planning/part/planned-part.ts";
import { partByHand, programByHand, PROGRAMMED_BY_HAND, valuesByHand } from "./by-hand.ts";
import { keysOf, planOf, requestOf } from "./plan-laws.ts";

test.each(PROGRAMMED_BY_HAND)("$name is a part, programmed by hand in $seconds s", (made) => {
  const { totalSeconds } = answerOf(programByHand(made)).simulation;
  expect(Math.abs(totalSeconds - made.seconds)).toBeLessThan(0.1);
  const { part, problems } = plannedPart(partByHand(made));
  expect(problems.filter((p) => p.severity === "error")).toEqual([]);
  expect(part?.rings.length).toBeGreaterThan(0);
});

/** Parts whose plans take little time; `npm run laws -- --trade` prints all. */
const QUICKLY_PLANNED: readonly string[] = [
  "l22-pin",
  "l22-clamp-shaft",
  "l12-820-contour",
  "l13-seal-groove",
  "l17-bush",
  "l19-another-size",
];

test.each(PROGRAMMED_BY_HAND.filter(({ name }) => QUICKLY_PLANNED.includes(name)))(
  "the plan of $name is complete and at most 5 % slower than by hand",
  (made) => {
    const request = requestOf(partByHand(made));
    const plan = request && planOf(request);
    expect(plan).toMatchObject({ isComplete: true, gouge: expect.closeTo(0, 2) as number });
    expect(plan?.programSeconds).toBeLessThan(made.seconds * 1.05);
  },
);

/** Parts that are planned with the cutting values of the program by hand, too. */
const ALIKE = ["l22-pin", "l13-seal-groove", "l17-bush"];

test.each(ALIKE)("with the cutting values of the program by hand the plan of %s is at most 5 %% slower", (name) => {
  const made = PROGRAMMED_BY_HAND.find((each) => each.name === name);
  const request = made && requestOf(partByHand(made));
  if (!request) throw new Error(name);
  const plan = planOf(request);
  const values = valuesByHand(made);
  const hand = Object.fromEntries(plan.steps.map(({ tried: { action } }) => [action.key, values[action.tool.T] ?? {}]));
  expect(plan.tools.map((T) => Object.keys(values[T] ?? {}).length > 2)).toEqual(plan.tools.map(() => true));
  const alike = planOf(request, { keep: keysOf(plan), hand });
  expect([alike.isComplete, keysOf(alike)]).toEqual([true, keysOf(plan)]);
  expect(alike.programSeconds).toBeLessThan(made.seconds * 1.05);
});
