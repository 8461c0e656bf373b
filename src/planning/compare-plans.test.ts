import { expect, test } from "vitest";
import { at, type Ring } from "../kernel/geometry/point.ts";
import { comparePlans, type ComparedOperation, type ComparedRow } from "./compare-plans.ts";

/** A box of stock: Z from left to right, radii from low to high, mm. */
const box = (left: number, right: number, low: number, high: number): readonly Ring[] => [
  [at(left, low), at(right, low), at(right, high), at(left, high)],
];

const cuts = (taken: readonly Ring[], tool = 1, cycle: number | null = 810, seconds = 10): ComparedOperation => ({
  taken,
  tool,
  cycle,
  seconds,
  thread: null,
});
const thread = (front: number, rear: number, isInside = false): ComparedOperation => ({
  ...cuts([], 12, 831),
  thread: { front, rear, isInside },
});

const face = cuts(box(0, 1, 0, 20)),
  rough = cuts(box(-50, 0, 14.4, 20)),
  finish = cuts(box(-50, 0, 14, 14.4), 3),
  groove = cuts(box(-22, -20, 12, 14), 10, 862);

const said = ({ own, other, moved }: ComparedRow) => `${own.join("+")}~${other.join("+")}${moved ? ` ${moved}` : ""}`;

test.each<
  [what: string, own: readonly ComparedOperation[], other: readonly ComparedOperation[], rows: readonly string[]]
>([
  ["the same plans", [face, rough, finish], [face, rough, finish], ["0~0", "1~1", "2~2"]],
  [
    "other oversizes",
    [cuts(box(-50, 0, 14.1, 20)), cuts(box(-50, 0, 14, 14.1))],
    [cuts(box(-50, 0, 14.4, 20)), cuts(box(-50, 0, 14, 14.4))],
    ["0~0", "1~1"],
  ],
  ["one operation that does the work of two", [cuts(box(-50, 0, 14, 20))], [rough, finish], ["0~0+1"]],
  ["a face in the roughing cut", [cuts([...box(0, 1, 0, 20), ...rough.taken])], [face, rough], ["0~0+1"]],
  ["an operation that only the own plan has", [rough, groove], [rough], ["0~0", "1~"]],
  [
    "one that only the other has, behind the one before it",
    [rough, finish],
    [rough, groove, finish],
    ["0~0", "~1", "1~2"],
  ],
  [
    "one that only the other has, before the first",
    [rough],
    [{ ...groove, taken: box(0, 3, 0, 20) }, rough],
    ["~0", "0~1"],
  ],
  ["another order", [groove, rough, finish], [rough, finish, groove], ["0~2 later", "1~0", "2~1"]],
  ["the same the other way round", [rough, finish, groove], [groove, rough, finish], ["0~1", "1~2", "2~0 earlier"]],
  [
    "threads by their stretch",
    [thread(0, -20), thread(-30, -40)],
    [thread(-30, -41), thread(2, -20)],
    ["0~1", "1~0 earlier"],
  ],
  ["a thread inside is another one", [thread(0, -20)], [thread(0, -20, true)], ["~0", "0~"]],
  ["a thread is no groove", [thread(0, -20)], [groove], ["~0", "0~"]],
  ["nothing", [], [rough], ["~0"]],
])("%s", (_, own, other, rows) => {
  expect(comparePlans(own, other).map(said)).toEqual(rows);
});

test.each([
  ["tool and cycle the same", rough, { isSameTool: true, isSameCycle: true, longer: 0 }],
  ["another tool, slower", { ...rough, tool: 2, seconds: 12 }, { isSameTool: false, isSameCycle: true, longer: -2 }],
  ["another cycle, faster", { ...rough, cycle: 811, seconds: 7 }, { isSameTool: true, isSameCycle: false, longer: 3 }],
  ["path blocks", { ...rough, cycle: null }, { isSameTool: true, isSameCycle: false, longer: 0 }],
] as const)("%s", (_, other, differs) => expect(comparePlans([rough], [other])[0]).toMatchObject(differs));
