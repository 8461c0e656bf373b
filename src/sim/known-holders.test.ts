import { expect, test } from "vitest";
import { at } from "../kernel/geometry/point.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import type { Step } from "../kernel/time/step.ts";
import { length } from "../kernel/units.ts";
import { unknownHolders } from "./known-holders.ts";

const drill: Tool = { T: 40, NAME: "DRILL", TYPE: "DRILL", TO: 8, RS: length(0), R: length(5), CUTLENGTH: length(80) };
const insert: Tool = { T: 1, NAME: "INSERT", TYPE: "ROUGH", TO: 1, RS: length(0.8) };
const blank = [[at(-100, 0), at(1, 0), at(1, 30), at(-100, 30)]];
const moved = (tool: Tool, to: number): Step => ({
  from: at(5, 0),
  move: { kind: "rapid", to: at(to, 0), phase: "rough", run: "rough", step: 1 },
  tool,
  block: 1,
  operation: null,
  seconds: 1,
});

test.each([
  ["its edges stand out of the hole", moved(drill, -78), blank, []],
  ["it is deeper than its edges are long", moved(drill, -79.5), blank, [40]],
  ["no length of its edges is stated", moved({ ...drill, CUTLENGTH: length(0) }, -10), blank, [40]],
  ["no blank is stated", moved(drill, -10), [], [40]],
  ["another tool without a holder", moved(insert, -10), blank, [1]],
])("%s", (_, step, rings, unknown) => {
  expect([...unknownHolders({ steps: [step], blank: rings })]).toEqual(unknown);
});
