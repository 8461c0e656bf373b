import { expect, test } from "vitest";
import { boxAround } from "../kernel/area/box.ts";
import { at, part, type Ring } from "../kernel/geometry/point.ts";
import { finishedPart } from "./finished.ts";
import type { SimulatedOperation } from "./simulation.ts";

const box = (left: number, right: number, low: number, high: number): Ring => [
  at(left, low),
  at(right, low),
  at(right, high),
  at(left, high),
];

/** A turned cylinder that is solid as far as its contour says, and a bore whose passes begin at `from`, mm. */
const operations = (from: number) =>
  [
    {
      plan: { part: box(-50, 0, 0, 30), area: [], contour: [part.line(at(0, 30), at(-50, 30))], openSide: at(0, 1) },
    },
    {
      plan: {
        part: [],
        area: box(-50, 0, from, 14),
        contour: [part.line(at(0, 14), at(-50, 14))],
        openSide: at(0, -1),
      },
    },
  ] as unknown as readonly SimulatedOperation[];

test.each([0, 10, 13])("nothing of a part stands inside its bore, whose passes begin at a radius of %d mm", (from) => {
  expect(boxAround(finishedPart(operations(from))).low).toBeCloseTo(14, 1);
});
