import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { comparePrograms } from "./compare.ts";

const HEAD = `0 BEGIN PGM S MM
1 BLK FORM CYLINDER Z D63.4 L90 DIST+0
2 TOOL CALL 1
3 FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500
4 L X+95 Z+52 R0 FMAX M303
5 CYCL DEF 811 SHOULDER, LONGITDNL. ~
 Q215=+0 ;MACHINING OPERATION ~
 Q493=+41.27 ;DIAMETER AT CONTOUR END ~
 Q463=+3 ;MAX. CUTTING DEPTH ~
 Q478=+0.3 ;ROUGHING FEED RATE
6 L X+63.4 Z+1.8 FMAX
7 CYCL CALL
`;
const SECOND = `8 TOOL CALL 3
9 CYCL DEF 812 SHOULDER, LONG. EXT. ~
 Q460=+2.35 ~
 Q463=+1.7
10 L X+41 Z+2.2 FMAX
11 CYCL CALL
`;
const END = "12 M30\n13 END PGM S MM\n";

/** Differences in short: kind, blocks, words. */
const differences = (a: string, b: string) =>
  comparePrograms(parse(a), parse(b)).differences.map(({ kind, a: one, b: other, words }) => [
    kind,
    one,
    other,
    ...words.map(({ name, from, to }) => `${name} ${from ?? "–"} → ${to ?? "–"}`),
  ]);

test("one value of a cycle, a tool, a coordinate and a feed are reported word by word", () => {
  const text = HEAD + SECOND + END;
  const other = text
    .replace("Q463=+3 ", "Q463=+2.4 ")
    .replace("TOOL CALL 1\n", "TOOL CALL 7\n")
    .replace("X+95", "X+94.5")
    .replace("Q478=+0.3 ", "Q478=+0.27 ")
    .replace("VC:180", "VC:165");
  expect(differences(text, other)).toEqual([
    ["changed", 2, 2, "T 1 → 7"],
    ["changed", 3, 3, "VC 180 → 165"],
    ["changed", 4, 4, "X +95 → +94.5"],
    ["changed", 5, 5, "Q463 3 → 2.4", "Q478 0.3 → 0.27"],
  ]);
});

test("an inserted operation is added block by block, and a reordered one is moved, with its changes", () => {
  expect(differences(HEAD + END, HEAD + SECOND + END).map(([kind, a, b]) => [kind, a, b])).toEqual(
    [8, 9, 10, 11].map((b) => ["added", null, b]),
  );
  const third =
    "TOOL CALL 5\nCYCL DEF 861 SIMPLE RECESS ~\n Q460=+2.35 ~\n Q463=+1.7 ~\n Q215=+3\nL X+48.1 Z-7.3 FMAX\nCYCL CALL M8\n";
  const swapped = differences(
    `${HEAD}${SECOND}${third}${END}`,
    `${HEAD}${third.replace("+1.7", "+1.9")}${SECOND}${END}`,
  );
  expect(swapped.map(([kind, a, b, ...words]) => [kind, a, b, ...words])).toEqual([
    ["moved", 12, 8],
    ["moved", 13, 9, "Q463 1.7 → 1.9"],
    ["moved", 14, 10],
    ["moved", 15, 11],
  ]);
});

test("spelling, comments and block numbers are distinguished, and do not change the meaning", () => {
  const text = HEAD + END;
  expect(differences(text, text.replaceAll(/^\d+ /gm, ""))).toEqual([]);
  expect(differences(text, text.replaceAll("\n", "\r\n"))).toEqual([]);
  expect(differences(text, text.replace("X+95 Z+52", "Z+52.000  X+95,0").replace("CYCL CALL", "cycl call"))).toEqual([
    ["form", 4, 4],
    ["form", 7, 7],
  ]);
  expect(
    differences(text, text.replace("FMAX M303", "FMAX M303 ;away").replace("0 BEGIN PGM S", "0 BEGIN PGM T")),
  ).toEqual([
    ["note", 0, 0],
    ["note", 4, 4],
  ]);
  expect(differences(text, text.replace("2 TOOL", "* - Rough\n; with care\n2 TOOL"))).toEqual([
    ["note", null, 2],
    ["note", null, 3],
  ]);
  expect(differences(text.replace("2 TOOL", "* - Rough\n2 TOOL"), text.replace("2 TOOL", "* - Turn\n2 TOOL"))).toEqual([
    ["note", 2, 2],
  ]);
});

test("what the reader does not understand, and skip marks, count as they are written", () => {
  const kept = (line: string) => `${HEAD}${line}\n${END}`;
  expect(differences(kept("FUNCTION COUNT INC 3.50"), kept("function  count inc 3.5"))).toEqual([["form", 8, 8]]);
  expect(differences(kept("FUNCTION COUNT INC 3.5"), kept("FUNCTION COUNT INC 4.5"))).toEqual([
    ["changed", 8, 8, " FUNCTION COUNT INC 3.5 → FUNCTION COUNT INC 4.5"],
  ]);
  expect(differences(HEAD + END, HEAD.replace("7 CYCL", "/7 CYCL") + END)).toEqual([["changed", 7, 7, "/ – → /"]]);
  expect(differences(kept('QS1 = "a b"'), kept('QS1 = "a  b"'))).toEqual([
    ["changed", 8, 8, ' QS1="a b" → QS1="a  b"'],
  ]);
  expect(differences(HEAD.replace("+3 ", "oops ") + END, HEAD.replace("+3 ", "ooops ") + END)).toEqual([
    ["changed", 5, 5, "Q463 OOPS → OOOPS"],
  ]);
});

test("lines of older cycles and formulas mean the same in every language and spelling", () => {
  const made = (lines: string) => `${HEAD}${lines}${END}`;
  const one =
    'CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL2 /"E"\nCYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 2.50\nFN 0: Q5 =+3.10\n';
  const other =
    'CYCL DEF 14.0 KONTUR\nCYCL DEF 14.1 KONTURLABEL2 /"E"\nCYCL DEF 9.0 VERWEILZEIT\nCYCL DEF 9.1 V.ZEIT2.5\nQ5 = 3.1\n';
  expect(differences(made(one), made(other)).map(([kind]) => kind)).toEqual(["note", "form", "note", "form", "form"]);
  expect(
    differences(made(one), made(other.replace("LABEL2", "LABEL3").replace("2.5", "2.4").replace("3.1", "3.2"))).filter(
      ([kind]) => kind === "changed",
    ),
  ).toEqual([
    ["changed", 9, 9, ' 2 "E" → 3 "E"'],
    ["changed", 11, 11, " 2.5 → 2.4"],
    ["changed", 12, 12, "Q5 3.1 → 3.2"],
  ]);
});

test.each([
  ["its title", "* - SECOND\n", ""],
  ["its tool call", "", ""],
  [
    "its title, between operations that end alike",
    "* - SECOND\n",
    "* - THIRD\nTOOL CALL 5\nCYCL DEF 861 ~\n Q460=+2\nL X+41 Z+2.2 FMAX\nCYCL CALL\nL Z+80 FMAX\n",
  ],
])("a removed or added operation begins with %s, even where its end equals the one before", (_, title, third) => {
  const away = "L Z+80 FMAX\n";
  const [one, other] = [`${HEAD}${away}${title}${SECOND}${away}${third}${END}`, `${HEAD}${away}${third}${END}`];
  const [first, count] = [title === "" ? 9 : 10, 5];
  const run = Array.from({ length: count }, (__, i) => first + i);
  const blocks = (a: string, b: string) =>
    comparePrograms(parse(a), parse(b)).differences.flatMap(({ kind, a: i, b: j }) =>
      kind === "note" ? [] : [[kind, i ?? j]],
    );
  expect(blocks(one, other)).toEqual(run.map((i) => ["removed", i]));
  expect(blocks(other, one)).toEqual(run.map((i) => ["added", i]));
});
