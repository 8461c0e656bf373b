import * as fc from "fast-check";
import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import { withCalls } from "./renumber-calls.ts";
import { readEntry, type ToolEntry } from "./tool-entry.ts";
import { shippedList, type ToolList } from "./tool-list.ts";
import { keepTools, renumberedTools, pairTools, type KeepAs } from "./tool-difference.ts";

const tool = (T: string, cells: ToolEntry["cells"] = {}): ToolEntry => ({
  id: `x${T}`,
  cells: { T, NAME: `N${T}`, TYPE: "ROUGH", TO: "3", RS: "0.8", ...cells },
});
const mine: ToolList = [tool("1"), tool("3"), tool("4", { RS: "0,40" }), tool("7.1")];

test("rows are set beside those of their number, and differ in what their cells mean", () => {
  const theirs = [
    tool("3", { RS: "3", CUTLENGTH: "9.7" }),
    tool("4", { RS: "0.4" }),
    tool("5"),
    tool("", { NAME: "NONE" }),
  ];
  expect(
    pairTools(theirs, mine).map(({ number, mine: own, differs }) => [number, own?.cells.T ?? null, differs]),
  ).toEqual([
    [3, "3", ["RS", "CUTLENGTH"]],
    [4, "4", []],
    [5, null, []],
    [null, null, []],
  ]);
});

test("free numbers are taken as they are, others as it was chosen", () => {
  const theirs = [
    tool("1", { RS: "1.6" }),
    tool("3", { RS: "3" }),
    tool("4", { RS: "0.4" }),
    tool("2", { RS: "0.2" }),
    tool("7.1", { ORI: "12.5" }),
  ];
  const ways: Record<string, KeepAs> = { x1: "mine", x3: "free", "x7.1": "theirs" };
  const { list, added, replaced, moved } = keepTools(mine, theirs, ({ entry }) => ways[entry.id] ?? "mine");
  // Number 2 is used by the job itself, so it is not free for another of its tools.
  expect(moved).toEqual([{ from: 3, to: 5 }]);
  expect([added, replaced]).toEqual([2, 1]);
  expect(list.map(({ cells }) => [cells.T, cells.RS, cells.ORI])).toEqual([
    ["1", "0.8", undefined],
    ["3", "0.8", undefined],
    ["4", "0,40", undefined],
    ["7.1", "0.8", "12.5"],
    ["5", "3", undefined],
    ["2", "0.2", undefined],
  ]);
  expect(new Set(list.map(({ id }) => id)).size).toBe(list.length);
  expect(renumberedTools(theirs, moved).map(({ cells }) => cells.T)).toEqual(["1", "5", "4", "2", "7.1"]);
});

test("whatever is chosen, no row of the table is lost but one that was to be replaced, and no number stands twice", () => {
  const cells = fc.record({
    RS: fc.constantFrom("0.8", "3", "-1", "x"),
    T: fc.constantFrom(..."0123456789".split(""), "3.1", "12"),
  });
  const theirs = fc
    .uniqueArray(cells, { maxLength: 8, selector: ({ T }) => T })
    .map((all) => all.map(({ T, RS }) => tool(T, { RS })));
  fc.assert(
    fc.property(theirs, fc.infiniteStream(fc.constantFrom<KeepAs>("mine", "theirs", "free")), (rows, ways) => {
      const { list, added, replaced, moved } = keepTools(mine, rows, () => ways.next().value);
      const numbers = list.map((entry) => readEntry(entry).number);
      expect(new Set(numbers).size).toBe(numbers.length);
      expect(list.length).toBe(mine.length + added);
      expect(list.filter((row) => mine.includes(row)).length).toBe(mine.length - replaced);
      const taken = [...mine, ...rows].map((entry) => readEntry(entry).number);
      for (const { to } of moved) expect(taken).not.toContain(to);
    }),
  );
});

test("keeping twice changes nothing more", () => {
  const theirs = [tool("3", { RS: "3" }), tool("9")];
  const once = keepTools(shippedList, theirs, () => "theirs");
  const twice = keepTools(once.list, theirs, () => "theirs");
  expect(twice).toEqual({ list: once.list, added: 0, replaced: 0, moved: [] });
});

test("calls name the new numbers, an index stays, and nothing else changes", () => {
  const text =
    '0 BEGIN PGM A MM\r\n1 TOOL CALL 3 Z S180 F0.2 ;rough\r\n2 TOOL CALL 3.2\r\n3 TOOL CALL "N3"\r\n4 TOOL CALL 30\r\n5 TOOL CALL Q3\r\n' +
    "6 TOOL DEF 3 L+0 R+5\r\n7 END PGM A MM\r\n";
  const { program, changed } = withCalls(parse(text), [
    { from: 3, to: 21 },
    { from: 21, to: 3 },
  ]);
  expect(changed).toBe(2);
  expect(print(program)).toBe(
    text.replace("TOOL CALL 3 Z", "TOOL CALL 21 Z").replace("TOOL CALL 3.2", "TOOL CALL 21.2"),
  );
  expect(print(withCalls(parse(text), []).program)).toBe(text);
});
