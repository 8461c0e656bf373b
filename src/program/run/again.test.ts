import { describe, expect, test } from "vitest";
import { AnswerCache } from "../../kernel/answer-cache.ts";
import { length } from "../../kernel/units.ts";
import { incrementalParser } from "../../nc/reread.ts";
import { parse } from "../../nc/parse.ts";
import type { Shop } from "../state/shop.ts";
import { readTools } from "../tools/read-tools.ts";
import { shippedTools } from "../tools/shipped-tools.ts";
import { incrementalRunner } from "./incremental-run.ts";
import { run } from "./run.ts";

/** Calls with all that a plan depends on before them. */
const PROGRAM = `0 BEGIN PGM S MM
1 BLK FORM CYLINDER Z D60 L90 DIST+1
2 FUNCTION MODE TURN
3 TOOL CALL 1 Z F0.35
4 FUNCTION TURNDATA SPIN VCONST:OFF S700
5 M136
7 L X+70 Z+5 R0 FMAX M303
8 CYCL DEF 811 SHOULDER, LONGITDNL. ~
 Q215=+0 ~
 Q460=+2 ~
 Q493=+50 ~
 Q494=-20 ~
 Q463=+5 ~
 Q478=FAUTO ~
 Q483=+0.4 ~
 Q484=+0.2 ~
 Q505=+0.15 ~
 Q506=+0
9 L X+62 Z+3 FMAX
6 TRANS DATUM AXIS Z-0.5
10 CYCL CALL
11 CALL LBL 2
/12 L X+64 F0.3
13 CYCL DEF 13.0 ORIENTATION
14 CYCL DEF 13.1 ANGLE0
15 TOOL CALL 3
16 FUNCTION TURNDATA SPIN VCONST:ON VC:200 SMAX2500
17 L X+54 Z+3 FMAX M303
18 CYCL DEF 811 SHOULDER, LONGITDNL. ~
 Q215=+0 ~
 Q460=+2 ~
 Q493=+40 ~
 Q494=-12 ~
 Q463=+5 ~
 Q478=+0.3 ~
 Q483=+0.4 ~
 Q484=+0.2 ~
 Q505=+0.15 ~
 Q506=+0
19 CYCL CALL
20 CALL PGM OTHER.H
21 TOOL CALL 41 Z
22 L X+0 Z+40 R0 FMAX
23 CYCL DEF 201 REAMING ~
 Q200=+2 ~
 Q201=-15 ~
 Q206=+0.2 ~
 Q203=+0
24 CYCL CALL
25 M30
25 LBL 2
26 L Z+20 FMAX
27 L Z+3 FMAX
28 LBL 0
29 END PGM S MM
`;
const OTHER = "BEGIN PGM OTHER MM\nL Z+30 FMAX\nEND PGM OTHER MM\n";

const drills = (R: number) => {
  const table = readTools(
    JSON.stringify({ tools: [{ T: 41, NAME: "D8", TYPE: "DRILL", R, "T-ANGLE": 118, LCUTS: 90 }] }),
  );
  return "tools" in table ? (table.mills ?? []) : [];
};
interface Given extends Partial<Shop> {
  readonly text?: string;
  /** Text of the called program; null: there is none. */
  readonly other?: string | null;
}
const shopOf = ({ text: _, other = OTHER, ...own }: Given): Shop => ({
  tools: shippedTools,
  mills: drills(4),
  rapid: 10_000,
  files: { find: (key) => (key === "OTHER.H" && other !== null ? { name: "OTHER.H", program: parse(other) } : null) },
  ...own,
});
const besideOf = ({ other = OTHER }: Given) => (other === null ? [] : [{ name: "OTHER.H", text: other }]);
const alone = (given: Given) => run(parse(given.text ?? PROGRAM), shopOf(given));

/** Runs one state after another, with all that is kept between runs. */
function session() {
  const [memory, read, runs] = [new AnswerCache(), incrementalParser(), incrementalRunner()];
  return (given: Given) => {
    memory.runEnded();
    return runs(read(given.text ?? PROGRAM), { ...shopOf(given), memory }, besideOf(given));
  };
}

const changed = (from: string, to: string): Given => {
  expect(PROGRAM.split(from).length).toBeGreaterThan(1);
  return { text: PROGRAM.replace(from, to) };
};
const first = shippedTools[0] as (typeof shippedTools)[number];

/** Each changes the result; `kept`: calls before it, whose plans are those of the run before. */
const CHANGES: readonly (readonly [what: string, given: () => Given, kept: number, from?: Given])[] = [
  ["a value of the second definition", () => changed("Q494=-12", "Q494=-13"), 1],
  ["a place before the second call", () => changed("17 L X+54", "17 L X+55"), 1],
  ["a place before the first call", () => changed("9 L X+62", "9 L X+63"), 0],
  ["a value of the first definition", () => changed("Q494=-20", "Q494=-21"), 0],
  ["the feed of the tool call, which a cycle takes", () => changed("F0.35", "F0.4"), 0],
  ["the datum", () => changed("Z-0.5", "Z-0.7"), 0],
  ["the spindle", () => changed("S700", "S800"), 0],
  ["the limit of the spindle", () => changed("SMAX2500", "SMAX700"), 0],
  ["the unit of feeds", () => changed("M136", "M137"), 0],
  ["the unit of the program", () => changed("PGM S MM", "PGM S INCH"), 0],
  ["the blank", () => changed("D60 L90", "D61 L90"), 0],
  ["the mode", () => changed("MODE TURN", "MODE MILL"), 0],
  ["a tool", () => changed("TOOL CALL 3", "TOOL CALL 7"), 1],
  ["a move that comes back from a label", () => changed("26 L Z+20", "26 L Z+21"), 0],
  ["the name of a label", () => changed("25 LBL 2", "25 LBL 3"), 0],
  ["a skip mark", () => ({ ...changed("9 L X+62", "/9 L X+62"), skipMarked: true }), 0],
  ["a block more", () => changed("20 CALL", "20 L Z+4 FMAX\n20 CALL"), 0],
  ["a block less", () => changed("17 L X+54 Z+3 FMAX M303\n", ""), 0],
  ["marked blocks are skipped", () => ({ skipMarked: true }), 0],
  ["the nose of a tool", () => ({ tools: shippedTools.map((t) => (t === first ? { ...t, RS: length(0.4) } : t)) }), 0],
  ["a drill", () => ({ mills: drills(5), other: null }), 0, { other: null }],
  ["a called program that was not there", () => ({}), 0, { other: null }],
  [
    "a tool that is refused",
    () => ({ refused: new Map([[3, []]]), tools: shippedTools.filter(({ T }) => T !== 3) }),
    0,
  ],
  ["the rapid rate", () => ({ rapid: 4000 }), 0],
  ["the machine", () => ({ machine: { name: "M", toolChange: 9 } }), 0],
  ["the called program", () => ({ other: OTHER.replace("Z+30", "Z+40") }), 0],
];

describe("a program that is run again", () => {
  const base = alone({});
  test("has what the changes need", () => {
    expect(base.operations.map(({ cycle }) => cycle)).toEqual([811, 811]);
    expect(base.operations.every(({ plan }) => plan.moves.length > 3)).toBe(true);
  });

  const changes = CHANGES.map(([what, make, kept, from = {}]) => ({ what, make, kept, from }));
  test.each(changes)("with another of: $what", ({ make, kept, from }) => {
    const given = make();
    const base = alone(from);
    const [expected, runs] = [alone(given), session()];
    expect(expected).not.toEqual(base);
    const before = runs(from);
    const made = runs(given);
    expect(made).toStrictEqual(expected);
    const own = made.operations.findIndex((each, i) => each !== before.operations[i]);
    expect(own < 0 ? before.operations.length : own).toBeGreaterThanOrEqual(kept);
    expect(runs(from)).toStrictEqual(base);
    // The same memory for a run that does not follow another one.
    const memory = new AnswerCache();
    run(parse(PROGRAM), { ...shopOf(from), memory });
    expect(run(parse(given.text ?? PROGRAM), { ...shopOf(given), memory })).toStrictEqual(expected);
  });

  test("and stopped between two calls goes on from there", () => {
    const runs = incrementalRunner();
    const program = parse(PROGRAM);
    const [shop, beside] = [shopOf({}), besideOf({})];
    let steps = 0;
    expect(runs.interruptible(program, shop, beside, () => (steps += 1) < 3)).toBeNull();
    let more = 0;
    expect(runs.interruptible(program, shop, beside, () => (more += 1) > 0)).toStrictEqual(base);
    let all = 0;
    expect(incrementalRunner().interruptible(program, shop, beside, () => (all += 1) > 0)).toStrictEqual(base);
    expect([steps, more < all]).toEqual([3, true]);
  });
});
