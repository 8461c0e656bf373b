import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { cellOf, type ToolEntry } from "./tool-entry.ts";
import { mergedTools } from "./tool-list.ts";
import { originsOf, writeBackTable, type TableWriteBack } from "./table-write-back.ts";
import { readTableText } from "./tool-table-text.ts";

const TURNING = [
  "BEGIN TOOLTURN.TRN MM Version: 'Update:110.24'",
  "#STRUCTBEGIN",
  "   NAME = T",
  "     WIDTH = 8",
  "#STRUCTEND",
  "T       NAME                ZL        XL        YL    RS       TO ORI   T-ANGLE P-ANGLE CUTLENGTH TYPE     SPB-INSERT DOC        ",
  "1       VORDREHER           +120,5    -40       +0    +0,8     1  +0    +95     +80     +12       ROUGH               Träger 4   ",
  "1.1     VORDREHER           +120,5    -38       +0    +0,8     1  +0    +95     +80     +12       ROUGH                          ",
  "5       SCHLICHTER          +118,25   -40       +0    +0,4     1  +0    +93     +35     +16       FINISH   LINKS      neu        ",
  "14      INNEN               +210      +12       +0    +0,4     7  +0    +95     +80     +9        ROUGH                          ",
  "[END]",
  "",
].join("\r\n");
const MILLING = [
  "BEGIN TOOL.T MM",
  "T    NAME            L        R       DL     DR     TL TYP  DOC      ",
  "0    NULL            +0       +0      +0     +0        9             ",
  "1    VORDREHER       +0       +0      +0     +0        29            ",
  "5                    +0       +0      +0     +0        29            ",
  "7    D16             +101.5   +8      +0     -0.02  L  0    gut      ",
  "9                    +0       +0      +0     +0        99            ",
  "31   BOHRER          +140     +4.25   +0     +0        1             ",
  "[END]",
  "",
].join("\n");

function imported(text: string, before: readonly ToolEntry[] = []): readonly ToolEntry[] {
  const read = readTableText(text);
  if (!("rows" in read)) throw new Error(read.problem);
  const origin = { name: "T", text, encoding: "utf-8" as const };
  return mergedTools(before, read.rows, read.table?.lines.map((at) => ({ origin, at })) ?? []).list;
}
const again = (text: string, list: readonly ToolEntry[]) =>
  writeBackTable({ name: "T", text, encoding: "utf-8" }, list) as TableWriteBack;
const changed = (list: readonly ToolEntry[], T: string, cells: ToolEntry["cells"]) =>
  list.map((entry) => (cellOf(entry, "T") === T ? { ...entry, cells: { ...entry.cells, ...cells } } : entry));
const differing = (a: string, b: string) => {
  const [as, bs] = [a.split("\n"), b.split("\n")];
  return bs.filter((line, i) => line !== as[i]);
};

describe("a table written back", () => {
  test.each([
    ["turning", TURNING],
    ["milling", MILLING],
    ["cut short", TURNING.replace("[END]\r\n", "")],
    ["without an end of line", MILLING.trimEnd()],
    ["trimmed", MILLING.replaceAll(/ +\n/g, "\n")],
  ])("%s: untouched it is the same to the byte", (_, text) => {
    expect(again(text, imported(text))).toEqual({ text, changed: 0, added: 0, removed: 0, shipped: 0, tooLong: [] });
  });

  test("one changed cell changes only its own characters: comma, sign, width, unknown columns and umlauts stay", () => {
    const next = again(TURNING, changed(imported(TURNING), "5", { RS: "1.2", NAME: "SCHLICHT-B" }));
    expect(differing(TURNING, next.text)).toEqual([
      "5       SCHLICHT-B          +118,25   -40       +0    +1,2     1  +0    +93     +35     +16       FINISH   LINKS      neu        \r",
    ]);
    expect(next).toMatchObject({ changed: 1, added: 0, removed: 0, tooLong: [] });
  });

  test("a deleted tool goes, a new one stands by its number, a sister tool keeps its index", () => {
    const list = imported(TURNING).filter((entry) => cellOf(entry, "T") !== "1.1");
    const fresh = {
      id: "n",
      cells: { T: "7", NAME: "NEU", TYPE: "ROUGH", TO: "3", RS: "0.8", "T-ANGLE": "62.5", "P-ANGLE": "55" },
    };
    const next = again(TURNING, [...list, fresh]);
    expect(next).toMatchObject({ changed: 0, added: 1, removed: 1 });
    expect(
      next.text
        .split("\r\n")
        .slice(6)
        .map((line) => line.slice(0, 13).trim()),
    ).toEqual(["1       VORDR", "5       SCHLI", "7       NEU", "14      INNEN", "[END]", ""]);
    expect(next.text).toContain(
      "7       NEU                                           +0,8     3        +62,5   +55               ROUGH                      ",
    );
    const read = readTableText(next.text);
    expect("rows" in read && read.rows.map((row) => row.T)).toEqual(["1", "5", "7", "14"]);
  });

  test("in a milling table a drill keeps its number for the type, an empty place takes a new tool, a turning tool its new name", () => {
    const list = changed(imported(MILLING), "31", { TYPE: "TAP", R: "5", PITCH: "1.5" });
    const place = { id: "p", cells: { T: "9", NAME: "D10", TYPE: "MILL", R: "5", L: "88" } };
    const turned = { id: "t", cells: { T: "5", NAME: "SCHLICHTER", TYPE: "FINISH", TO: "1", RS: "0.4" } };
    const next = again(MILLING, [...list, place, turned]);
    expect(differing(MILLING, next.text)).toEqual([
      "5    SCHLICHTER      +0       +0      +0     +0        29            ",
      "9    D10             +88      +5      +0     +0        0             ",
      "31   BOHRER          +140     +5      +0     +0        2             ",
    ]);
    expect(next).toMatchObject({ changed: 3, added: 0, removed: 0 });
  });

  test("text too long for its column keeps its old value and is reported; a number loses decimals first", () => {
    const next = again(
      MILLING,
      changed(imported(MILLING), "7", { NAME: "A-NAME-OF-TWENTY-CHA", L: "101.12345", DR: "-0.12345" }),
    );
    expect(next.tooLong).toEqual([{ tool: "7", column: "NAME" }]);
    expect(differing(MILLING, next.text)).toEqual([
      "7    D16             +101.123 +8      +0     -0.123 L  0    gut      ",
    ]);
  });

  test("inches come back as inches, and only where something changed", () => {
    const text = TURNING.replace(" MM", " INCH");
    const list = imported(text);
    expect(cellOf(list[2] as ToolEntry, "RS")).toBe("10.16");
    expect(again(text, list).text).toBe(text);
    expect(differing(text, again(text, changed(list, "14", { RS: "0.8" })).text)[0]).toContain("+0,0315");
  });

  test("a row with an error keeps its line", () => {
    expect(again(TURNING, changed(imported(TURNING), "5", { RS: "abc" })).text).toBe(TURNING);
  });

  test("the file with most rows is the first one", () => {
    const list = imported(TURNING, imported(TURNING.replaceAll("VORDREHER", "ANDERER  ").replace("14  ", "15  ")));
    expect(originsOf(list, false).map(({ text }) => text === TURNING)).toEqual([true, false]);
    expect(originsOf(list, true)).toEqual([]);
  });

  test("any table untouched is the same, one edit changes one line, and what was written is read", () => {
    const columns = ["T", "NAME", "RS", "TO", "TYPE", "T-ANGLE", "P-ANGLE", "MYSTERY", "ZL", "DOC"];
    const made = fc.record({
      widths: fc.array(fc.integer({ min: 9, max: 20 }), { minLength: 10, maxLength: 10 }),
      order: fc.shuffledSubarray(columns, { minLength: 10 }),
      rows: fc.uniqueArray(
        fc.record({
          T: fc.integer({ min: 1, max: 999 }),
          radius: fc.integer({ min: 0, max: 40 }),
          mystery: fc.stringMatching(/^[ -~]{0,7}$/),
        }),
        { selector: (row) => row.T, minLength: 1, maxLength: 8 },
      ),
      comma: fc.boolean(),
      trimmed: fc.boolean(),
      eol: fc.constantFrom("\n", "\r\n"),
    });
    fc.assert(
      fc.property(made, fc.nat(7), ({ widths, order, rows, comma, trimmed, eol }, pick) => {
        const line = (cells: Readonly<Record<string, string>>) => {
          const text = order.map((column, i) => (cells[column] ?? "").padEnd(widths[i] ?? 9)).join("");
          return trimmed ? text.trimEnd() : text;
        };
        const number = (n: number) => String(n / 10).replace(".", comma ? "," : ".");
        const text = [
          "BEGIN X.TRN MM",
          line(Object.fromEntries(columns.map((column) => [column, column]))),
          ...rows.map(({ T, radius, mystery }) =>
            line({
              T: String(T),
              NAME: `N${T}`,
              RS: number(radius),
              TO: "1",
              TYPE: "ROUGH",
              "T-ANGLE": "95",
              "P-ANGLE": "55",
              MYSTERY: mystery.trim(),
              DOC: "a  b",
            }),
          ),
          "[END]",
          "",
        ].join(eol);
        const list = imported(text);
        expect(again(text, list).text).toBe(text);
        const T = String(rows[pick % rows.length]?.T);
        const next = again(text, changed(list, T, { RS: "4.7" }));
        expect(differing(text, next.text)).toHaveLength(1);
        const read = readTableText(next.text);
        expect("rows" in read && read.rows).toEqual(changed(list, T, { RS: "4.7" }).map((entry) => entry.cells));
      }),
      { numRuns: 300 },
    );
  });
});
