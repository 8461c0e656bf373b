import { expect, test } from "vitest";
import type { Move } from "../kernel/plan/move.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { at } from "../kernel/geometry/point.ts";
import { feed, length } from "../kernel/units.ts";
import { simulate } from "./simulate.ts";

const bar: Tool = {
  T: 9,
  NAME: "BAR-3",
  TYPE: "RECTURN",
  TO: 2,
  RS: length(0.2),
  CUTWIDTH: length(3),
  CUTLENGTH: length(30),
};
const purpose = { phase: "rough", run: "rough", step: 1 } as const;

/** Faults of feed moves outside cycles (`r`: at rapid), after a bar of ⌀20 was parted off at Z-20. */
function faultsAfterParting(moves: readonly (readonly [z: number, r: number, rapid?: "r"])[]) {
  let from = at(-20, 12);
  const steps = ([[-20, -1], [-20, 12, "r"], ...moves] as const).map(([z, r, how], i) => {
    const to = at(z, r);
    const move: Move =
      how === "r"
        ? { kind: "rapid", to, ...purpose }
        : { kind: "feed", to, feed: feed(0.3), feedUnit: "mm/rev", ...purpose };
    const step = { from, move, tool: bar, block: 10 + i, operation: null, seconds: 1 };
    from = to;
    return step;
  });
  const blank = [[at(-50, 0), at(0, 0), at(0, 10), at(-50, 10)]];
  return simulate({ blank, steps, operations: [], unproved: [] }).findings.map(({ kind, block }) => [kind, block]);
}

test.each([
  [
    "that only runs where the piece was cuts it",
    [
      [-8, 12, "r"],
      [-8, 5],
    ],
    [["cutOnLoosePiece", 13]],
  ],
  [
    "through that place to the held bar cuts the bar",
    [
      [-8, 12, "r"],
      [-8, 5],
      [-26, 5],
      [-26, 12],
    ],
    [],
  ],
  [
    "past that place cuts nothing",
    [
      [-8, 12, "r"],
      [-8, 10.1],
      [-12, 10.1],
    ],
    [],
  ],
] as const)("a feed move %s", (_, moves, faults) => expect(faultsAfterParting(moves)).toEqual(faults));
