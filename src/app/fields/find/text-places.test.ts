import { expect, test } from "vitest";
import { parse } from "../../../nc/parse.ts";
import { placesIn } from "./text-places.ts";

const PROGRAM = parse(`0 BEGIN PGM SHAFT MM
1 TOOL CALL 2 Z S500
2 * - ROUGHING
3 CYCL DEF 812 SHOULDER ~
  Q215=+0 ~
  Q460=+2
4 LBL 2
5 FN 0: Q21 = +4
6 L X+Q21 ; Q210
7 LBL "GROOVE"
8 TOOL CALL "FINISH"
9 LBL 0
10 END PGM SHAFT MM
`);

test.each([
  ["", []],
  ["2", ["block 2", "tool T 2", "label LBL 2"]],
  ["1", ["block 1", "block 10"]],
  ["lbl", ["label LBL 2", "label LBL GROOVE"]],
  ["groove", ["label LBL GROOVE"]],
  ["t2", ["tool T 2"]],
  ["t", ["tool T 2", "tool T FINISH"]],
  ["fini", ["tool T FINISH"]],
  ["812", ["cycle 812"]],
  ["shoulder", ["cycle 812"]],
  ["q460", ["parameter Q460"]],
  ["q21", ["parameter Q21", "parameter Q21", "parameter Q215"]],
  ["rough", ["structure *"]],
  ["lbl 0", []],
])("%j", (typed, expected) =>
  expect(placesIn(PROGRAM, typed).map(({ kind, key }) => `${kind} ${key}`)).toEqual(expected),
);

test("a parameter is gone to on its line", () => {
  expect(placesIn(PROGRAM, "Q460")).toEqual([
    { kind: "parameter", key: "Q460", index: 3, number: 3, q: "Q460", text: "Q460=+2" },
  ]);
});
