import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { byOperation } from "./by-operation.ts";
import { comparePrograms } from "./compare.ts";

/** Operations of one line each, by letter; a title, a tool, a cycle with a value, and its call. */
const CYCLES: Readonly<Record<string, readonly [cycle: number, tool: number, q: string]>> = {
  A: [811, 1, "Q463"],
  B: [812, 3, "Q463"],
  C: [861, 9, "Q463"],
  D: [821, 7, "Q463"],
  E: [841, 10, "Q463"],
};
/** `A B3`: operation A, then B with another value. */
const program = (letters: string) => {
  const operations = letters
    .split(" ")
    .filter(Boolean)
    .flatMap((word) => {
      const [cycle, tool, q] = CYCLES[word[0] ?? ""] ?? [810, 1, "Q463"];
      return [
        `* - PART ${word[0]}`,
        `TOOL CALL ${tool}`,
        "FUNCTION TURNDATA SPIN VCONST:OFF S700",
        `CYCL DEF ${cycle} CYCLE ~`,
        ` ${q}=+${word.slice(1) || "2"} ~`,
        " Q460=+2 ~",
        " Q215=+0",
        `L X+${60 + tool} Z+2 FMAX`,
        "CYCL CALL",
      ];
    });
  return [
    "BEGIN PGM S MM",
    "BLK FORM CYLINDER Z D60 L90 DIST+0",
    "FUNCTION MODE TURN",
    ...operations,
    "M30",
    "END PGM S MM",
    "",
  ].join("\n");
};

function said(one: string, other: string): string {
  const [a, b] = [parse(program(one)), parse(program(other))];
  const [frame, ...operations] = byOperation(a, b, comparePrograms(a, b));
  const each = operations.map(({ outcome, a: was, b: is, differences }) => {
    const name = (is ?? was)?.title?.replace("PART ", "") ?? "";
    const places = `${was ? was.place : "–"}>${is ? is.place : "–"}`;
    const changed = differences.filter(({ words }) => words.length > 0).length;
    const isWhole = outcome === "added" || outcome === "removed";
    return `${name} ${outcome} ${places}${changed > 0 && !isWhole ? ` ${changed}` : ""}`;
  });
  return [frame?.differences.length ?? 0, ...each].join(", ");
}

test.each([
  ["A B C", "A B C", "0, A kept 0>0, B kept 1>1, C kept 2>2"],
  ["A B C", "A B3 C", "0, A kept 0>0, B kept 1>1 1, C kept 2>2"],
  ["A B C", "A C", "0, A kept 0>0, B removed 1>–, C kept 2>1"],
  ["A B C", "B C", "0, A removed 0>–, B kept 1>0, C kept 2>1"],
  ["A B C", "A B", "0, A kept 0>0, B kept 1>1, C removed 2>–"],
  ["A B C D", "A D", "0, A kept 0>0, B removed 1>–, C removed 2>–, D kept 3>1"],
  ["A C", "A B C", "0, A kept 0>0, B added –>1, C kept 1>2"],
  ["", "A B", "0, A added –>0, B added –>1"],
  ["A B", "", "0, A removed 0>–, B removed 1>–"],
  // As few as possible are said to have moved.
  ["A B C D", "B C D A", "0, B kept 1>0, C kept 2>1, D kept 3>2, A moved 0>3"],
  ["A B C D E", "E3 A B C D", "0, E moved 4>0 1, A kept 0>1, B kept 1>2, C kept 2>3, D kept 3>4"],
] as const)("%s against %s", (a, b, rows) => {
  expect(said(a, b)).toBe(rows);
});
