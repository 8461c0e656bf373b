import { expect, test } from "vitest";
import { at, part, type Segment } from "../geometry/point.ts";
import { selfCrossing } from "./crossing.ts";

/** An arc whose centre is rounded to three decimals: its circle passes its end 0.0001 mm behind it. */
const rounded: Segment = {
  kind: "arc",
  from: at(-63, 34.5),
  to: at(-79, 38.5),
  centre: at(-59.168, 83.8285),
  turn: "cw",
};

test.each([
  ["a line behind an arc with a rounded centre", [rounded, part.line(at(-79, 38.5), at(-81, 38.5))], null],
  [
    "a line that comes back through the arc",
    [rounded, part.line(at(-79, 38.5), at(-70, 30)), part.line(at(-70, 30), at(-70, 40))],
    [2, 0],
  ],
] as const)("%s", (_, chain, crossing) => {
  expect(selfCrossing(chain)).toEqual(crossing);
});
