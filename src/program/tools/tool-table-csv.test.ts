import fc from "fast-check";
import { describe, expect, test } from "vitest";
import type { Tool } from "../../kernel/plan/tool.ts";
import { shippedTools } from "./shipped-tools.ts";
import { readEntry } from "./tool-entry.ts";
import { readTableCsv, writeTableCsv } from "./tool-table-csv.ts";
import { readToolFile } from "./tool-table-json.ts";

const read = (text: string) => {
  const file = readTableCsv(text);
  return "rows" in file ? file : { rows: [], leftOut: [file.problem] };
};

describe("tools as a sheet", () => {
  const row = { T: "21", NAME: 'SHOP "A"; 35', TYPE: "FINISH", TO: "1", RS: "0.4", "T-ANGLE": "93.5" };

  test.each([
    ["comma", 'T,NAME,TYPE,TO,RS,T-ANGLE\n21,"SHOP ""A""; 35",FINISH,1,0.4,93.5\n'],
    [
      "semicolon and decimal comma, as German spreadsheets write it",
      '\uFEFFT;NAME;TYPE;TO;RS;T-ANGLE\r\n21;"SHOP ""A""; 35";FINISH;1;0,4;93,5\r\n',
    ],
    [
      "tab, another order, small letters",
      'rs\tt\ttype\tname\tT-Angle\tto\n"0,4"\t21\tfinish\t"SHOP ""A""; 35"\t+93,50\t1',
    ],
    ["a line that names the separator", 'sep=|\nT|NAME|TYPE|TO|RS|T-ANGLE\n21|"SHOP ""A""; 35"|FINISH|1|0,4|93.5'],
  ])("%s", (_, text) => {
    const [found = {}] = read(text).rows;
    expect({ ...found, "T-ANGLE": String(Number(found["T-ANGLE"])) }).toEqual(row);
    expect(readToolFile(text)).toMatchObject({ rows: [{ T: "21", RS: "0.4" }] });
  });

  test("columns that are not understood are named, a line break in quotes stays, empty lines are none", () => {
    expect(read('T,Price,NAME,RS,,Ort\n1,"3,50","A\nB",0.8,,x\n,,,,,\n2,,C,1,,\n')).toMatchObject({
      rows: [
        { T: "1", NAME: "A\nB", RS: "0.8" },
        { T: "2", NAME: "C", RS: "1" },
      ],
      leftOut: ["Price", "Ort"],
    });
  });

  test("a row with a radius and no tip is a milling tool, a drill keeps its type, and a holder comes with its cells", () => {
    const text =
      "T;TYPE;R;RS;TO;LCUTS;HOLDER.WIDTH;holder.length;HOLDER.HEAD\n7;;8;;;20;;;\n8;drill;4,25;;;47;;;\n" +
      "9;ROUGH;;0,8;1;;25;114;1/1.2 9.1/6.2 32/36\n";
    expect(read(text).rows).toEqual([
      { T: "7", TYPE: "MILL", R: "8", LCUTS: "20" },
      { T: "8", TYPE: "DRILL", R: "4.25", LCUTS: "47" },
      {
        T: "9",
        TYPE: "ROUGH",
        RS: "0.8",
        TO: "1",
        width: "25",
        length: "114",
        head: "1/1.2 9.1/6.2 32/36",
      },
    ]);
  });

  test.each([
    ["", "notATable"],
    ["hello, world", "notATable"],
    ["T", "notATable"],
    ["T,NAME", "noRows"],
    ["A;B;C\n1;2;3", "notATable"],
  ])("%j: %s", (text, problem) => expect(readTableCsv(text)).toEqual({ problem }));

  /** Names that a spreadsheet would run, split or trim, and one of the marks that keep them from it. */
  const NAMES = ["=1+1", "+A", "-B", "-5", "@x", "\tX", "\rX", 'A"B', "A;B,C", "A\r\nB", " A ", "'=1", "''", "<b>"];

  test.each([",", "."])("what is written with a decimal %s is read again, holders and every name too", (decimal) => {
    const mills = [
      { T: 40, NAME: "D8,5", R: 4.25, L: 120.125, PL: 1.5, TYPE: "DRILL" as const },
      ...NAMES.map((NAME, i) => ({ T: 41 + i, NAME, R: 8, DR: -0.02 })),
    ];
    const limited = { DAXN: 24, DAXX: 60.5, CDX: 12, CUTDIA: 32, DMIN: 25, SUPPORT: "CURVED" } as unknown as Tool;
    const tools = shippedTools.map((tool, i) => ({
      ...tool,
      NAME: NAMES[i] ?? tool.NAME,
      ...(tool.T === 8 && limited),
    }));
    const text = writeTableCsv(tools, mills, decimal);
    // A correction stays a number, for a spreadsheet too.
    expect(text).toContain(`${decimal === "," ? ";" : ","}-0${decimal}02${decimal === "," ? ";" : ","}`);
    const { rows, leftOut } = read(text);
    expect(leftOut).toEqual([]);
    const found = rows.map((cells) => readEntry({ id: "r", cells }));
    expect(found.flatMap(({ tool }) => tool ?? [])).toEqual(tools);
    expect(found.flatMap(({ mill }) => mill ?? [])).toEqual(mills);
  });

  test("no text makes it throw", () =>
    fc.assert(
      fc.property(fc.oneof(fc.string(), fc.stringMatching(/^T[,;\t]NAME[,;\t]RS\n["A-Z0-9,;\t\n.]{0,60}$/)), (text) => {
        for (const cells of read(text).rows) readEntry({ id: "r", cells });
      }),
      { numRuns: 1000 },
    ));
});
