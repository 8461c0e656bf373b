import { expect, test } from "vitest";
import { engine } from "../src/app/calculation/engine.ts";
import { repairsOf } from "../src/app/fields/blocks/repairs.ts";
import type { FindingEntry } from "../src/app/findings/entry.ts";
import { findingsOf } from "../src/app/findings/findings.ts";
import { parse } from "../src/nc/parse.ts";
import { print } from "../src/nc/program.ts";
import { NC_OUTPUTS } from "../src/program/machine/nc-output.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";

/** A shoulder that is right; every row below changes one thing in it. */
const RIGHT = `0 BEGIN PGM RIGHT MM
1 BLK FORM CYLINDER Z D62 L90 DIST+1
2 FUNCTION MODE TURN
3 TOOL CALL 1
4 FUNCTION TURNDATA SPIN VCONST:ON VC:170 SMAX2400
5 M136
6 L X+92 Z+42 R0 FMAX
7 CYCL DEF 812 SHOULDER, LONG. EXT. ~
Q215=+0 ~
Q460=+2 ~
Q491=+62 ~
Q492=+0 ~
Q493=+47.4 ~
Q494=-33 ~
Q495=+0 ~
Q501=+0 ~
Q502=+0 ~
Q500=+0.8 ~
Q496=+0 ~
Q503=+0 ~
Q504=+0 ~
Q463=+2.5 ~
Q478=+0.28 ~
Q483=+0.4 ~
Q484=+0.2 ~
Q505=+0.18 ~
Q506=+0
8 L X+62 Y+0 Z+3 FMAX M303
9 CYCL CALL
10 L Z+42 FMAX
11 M30
12 LBL 3
13 L X+92 FMAX
14 LBL 0
15 END PGM RIGHT MM
`;

const listed = (text: string): readonly FindingEntry[] => {
  const table = { tools: shippedTools, mills: [], refused: new Map() };
  const outcome = engine.update({ version: 1, text, table, rapid: 10_000, control: "TNC 640" });
  return findingsOf(null, outcome).filter(({ issue }) => issue.severity !== "info" && issue.code !== "neverReached");
};

/** The text with the first thing that is offered for a finding; null without an offer. */
function mended(text: string, entry: FindingEntry): string | null {
  const { issue } = entry;
  if ("fix" in issue && issue.fix) {
    const { offset, length, text: right } = issue.fix;
    return text.slice(0, offset) + right + text.slice(offset + length);
  }
  const [repair] = repairsOf(parse(text), entry, "en", NC_OUTPUTS.manual);
  return repair ? print(repair.next()) : null;
}

test("the program on which the rows are based has no finding", () => {
  expect(listed(RIGHT)).toEqual([]);
});

/** What is wrong, the text and what stands in its place, all that is listed, and what the first offer writes there. */
const rows: readonly (readonly [what: string, from: string, to: string, codes: readonly string[], right: string])[] = [
  ["a slip in TOOL CALL", "TOOL CALL 1", "TOLL CALL 1", ["error notUnderstood"], "TOOL CALL 1"],
  ["a blank left out", "TOOL CALL 1", "TOOLCALL 1", ["error notUnderstood"], "TOOL CALL 1"],
  ["a slip in the blank", "BLK FORM", "BLK FROM", ["warning notUnderstood"], "BLK FORM"],
  ["a slip in the mode", "MODE TURN", "MODE TRUN", ["error notUnderstood"], "MODE TURN"],
  ["a slip in a word", "VCONST", "VCONTS", ["error wordNotUnderstood"], "VCONST"],
  ["a slip in a feed", "Z+3 FMAX", "Z+3 FMX", ["error wordNotUnderstood"], "Z+3 FMAX"],
  ["a slip in a call", "CYCL CALL", "CYCL CAL", ["warning notUnderstood"], "CYCL CALL"],
  ["feed per minute", "M136", "M137", ["warning feedUnlikely"], "M136"],
  [
    "a label that is missing",
    "10 L Z+42",
    "10 CALL LBL 5\n11 L Z+42",
    ["error labelMissing"],
    "10 CALL LBL 3\n11 L Z+42",
  ],
  ["a forgotten minus", "Q494=-33", "Q494=+33", ["error endInFront"], "Q494=-33"],
  [
    "ends of the contour exchanged",
    "Q492=+0 ~\nQ493=+47.4 ~\nQ494=-33",
    "Q492=-33 ~\nQ493=+47.4 ~\nQ494=+0",
    ["error endsExchanged"],
    "Q492=+0 ~\nQ493=+47.4 ~\nQ494=-33",
  ],
  ["no infeed", "Q463=+2.5", "Q463=+0", ["error outOfRange"], "Q463=+3"],
];

test.each(rows)("%s: one finding, and its offer mends it", (_, from, to, codes, right) => {
  const text = RIGHT.replace(from, to);
  const found = listed(text);
  expect(found.map(({ issue: { severity, code } }) => `${severity} ${code}`)).toEqual(codes);
  const after = found[0] && mended(text, found[0]);
  expect(after).toBe(RIGHT.replace(from, right));
  expect(listed(after ?? "")).toEqual([]);
});

test("a corner that is wanted sharp, and a start point close to the work, are no warnings", () => {
  expect(listed(RIGHT.replace("Q500=+0.8", "Q500=+0"))).toEqual([]);
  expect(listed(RIGHT.replace("Z+3 FMAX M303", "Z+1 FMAX M303"))).toEqual([]);
});

test("an unknown tool is one finding, at the operation for which a tool is offered", () => {
  const found = listed(RIGHT.replace("TOOL CALL 1", "TOOL CALL 42"));
  expect(found.map(({ issue }) => issue.code)).toEqual(["toolUnknown"]);
  expect(found[0]?.operation).toBe(0);
});

test("a diameter larger than the blank is named, not the tool", () => {
  expect(listed(RIGHT.replace("Q493=+47.4", "Q493=+94.8")).map(({ issue }) => issue.code)).toEqual(["diameterOutside"]);
});
