import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { shippedTools } from "../tools/shipped-tools.ts";
import { incrementalRunner } from "./incremental-run.ts";
import { run } from "./run.ts";

const HEAD = `BEGIN PGM S MM
BLK FORM CYLINDER Z D80 L90 DIST+1
FUNCTION MODE TURN
Q1 = +1
TOOL CALL 1
FUNCTION TURNDATA SPIN VCONST:OFF S700
L X+90 Z+5 R0 FMAX M303
`;

/** A block whose states differ, `#` being what differs, with what it acts on; a tool call is where a run is resumed. */
const PROGRAMS: readonly (readonly [what: string, lines: string, states: readonly string[]])[] = [
  [
    "an element of a contour that was read before the state",
    `CYCL DEF 14.0 CONTOUR GEOMETRY
CYCL DEF 14.1 CONTOUR LABEL 91
CYCL DEF 810 TURN CONTOUR LONG. ~
Q215=+1 ~
Q460=+2 ~
Q499=+0 ~
Q463=+5 ~
Q478=+0.3 ~
Q483=+0.5 ~
Q484=+0.2 ~
Q505=+0.1 ~
Q487=+1 ~
Q488=+0 ~
Q479=+0 ~
Q480=+0 ~
Q482=+0 ~
Q506=+0
L X+82 Z+2 FMAX
CYCL CALL
TOOL CALL 3
L X+95 Z+20 FMAX M30
LBL 91
L X+50 Z+0
L Z-#
L X+82
LBL 0`,
    ["10", "12"],
  ],
  [
    "a block behind a repetition that was resumed half-way",
    `LBL 1
TOOL CALL 3
L X+90 Z+4 R0 FMAX M303
L Z+1 F0.2
CALL LBL 1 REP2
L Z+#
M30`,
    ["2", "3"],
  ],
  [
    "a jump to what the former run reached",
    `TOOL CALL 3
Q1 = +#
FN 9: IF +Q1 EQU +1 GOTO LBL 5
M30
LBL 5
L X+92 FMAX
LBL 0
L X+94 FMAX`,
    ["1", "2"],
  ],
  [
    "an element that was solved with the one before it",
    `L X+60 Z+3 FMAX
L Z+1 F0.2
FL AN180
FL X+76 Z-# AN135
L X+90 FMAX
M30`,
    ["10", "11", "12"],
  ],
];

test.each(PROGRAMS)("a run is resumed as from its beginning: %s", (_, lines, states) => {
  const runs = incrementalRunner();
  const shop = { tools: shippedTools, rapid: 10_000 };
  const results = states.map((state) => {
    const program = parse(`${HEAD}${lines.replace("#", state)}\nEND PGM S MM\n`);
    const alone = run(program, shop);
    expect(runs(program, shop, [])).toStrictEqual(alone);
    return alone;
  });
  // What differs acts on the result.
  expect(new Set(results.map((each) => JSON.stringify(each))).size).toBe(states.length);
});
