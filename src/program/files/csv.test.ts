import fc from "fast-check";
import { expect, test } from "vitest";
import { csvCell, csvCells, csvFormat, writeCsv } from "./csv.ts";

test.each([
  [`=HYPERLINK("x")`, `"'=HYPERLINK(""x"")"`],
  ["+49 7", "'+49 7"],
  ["-1", "'-1"],
  ["@a", "'@a"],
  ["＝1+1", "'＝1+1"],
  ["  =1+1", "'  =1+1"],
  ["\ta", `"'\ta"`],
  ["\ra", `"'\ra"`],
  ["'=1", "''=1"],
  ["'s", "'s"],
  ["李雷“一”", "李雷“一”"],
  ["a;b", `"a;b"`],
  ["a\r\n=b", `"a\r\n=b"`],
  ["Zoé", "Zoé"],
])("%j is text in a CSV file", (text, cell) => expect(csvCell(text, csvFormat(","))).toBe(cell));

test("a CSV file is written as the spreadsheets of a language read it; a number stays one", () => {
  const rows = [
    ["Name", "s"],
    ["Ada", 61.7],
    ["", null],
    ["b,c", -3],
  ] as const;
  expect(writeCsv(rows, csvFormat(","))).toBe("\uFEFFName;s\r\nAda;61,7\r\n;\r\nb,c;-3\r\n");
  expect(writeCsv([["Name"], ["b,c"], [-0.5]], csvFormat("."))).toBe('\uFEFFName\r\n"b,c"\r\n-0.5\r\n');
});

test("any text is read again as it was, and none is written as a formula", () => {
  const text = fc.oneof(fc.string({ unit: "grapheme" }), fc.stringMatching(/^[ '"=+\-@;,\t\r\nA]{0,8}$/));
  fc.assert(
    fc.property(
      fc.array(fc.tuple(fc.constant("T"), text, text), { minLength: 1 }),
      fc.constantFrom(",", "."),
      (rows, decimal) => {
        const format = csvFormat(decimal);
        expect(csvCells(writeCsv(rows, format).slice(1), format.separator)).toEqual(rows);
        for (const cell of rows.flat()) expect(csvCell(cell, format)).not.toMatch(/^"?(?:\s*[=+\-@]|[\t\r\n])/);
      },
    ),
  );
});
