import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { readEntry } from "../tools/tool-entry.ts";
import { proposedAssignment, signatureOf, toolsOfSheet, withWords, wordsIn } from "./assignment.ts";
import { MOST_COLUMNS, MOST_LINES, readSheet } from "./sheet.ts";
import { orientationOfWord, typeOfWord } from "./value-words.ts";
import { sheetOfWorkbook } from "./workbook.ts";

const proposed = (text: string) => {
  const sheet = readSheet(text);
  if (!sheet) return null;
  const assignment = proposedAssignment(sheet);
  return { cells: assignment.columns.map((column) => column?.cell ?? null), ...toolsOfSheet(sheet, assignment) };
};

describe("titles and tools of sheets", () => {
  test.each([
    [
      "German, semicolon and decimal comma",
      "Nr;Name;Typ;Orientierung;Radius;Einstellwinkel;Spitzenwinkel\n1;Schruppen;ROUGH;1;0,8;95;80\n",
      [{ T: "1", NAME: "Schruppen", TYPE: "ROUGH", TO: "1", RS: "0.8", "T-ANGLE": "95", "P-ANGLE": "80" }],
    ],
    [
      "English, comma, point, units",
      'Tool No.,Description,Type,Tip orientation,Nose radius (mm),Setting angle [°],Point angle\n3,"Finish, OD",Finishing,3,0.4mm,93°,55\n',
      [{ T: "3", NAME: "Finish, OD", TYPE: "FINISH", TO: "3", RS: "0.4", "T-ANGLE": "93", "P-ANGLE": "55" }],
    ],
    [
      "French, tab, words for types and sides",
      "N° outil\tDésignation\tType d’outil\tOrientation\tRayon de bec\tLargeur\n7\tGorge 3\tgorge\tneutre\t0,2\t3\n",
      [{ T: "7", NAME: "Gorge 3", TYPE: "RECESS", TO: "2", RS: "0.2", CUTWIDTH: "3" }],
    ],
    [
      "Chinese",
      "刀具号,名称,类型,刀尖方向,刀尖半径,主偏角,刀尖角\n5,内孔镗刀,粗车,7,0.4,95,80\n",
      [{ T: "5", NAME: "内孔镗刀", TYPE: "ROUGH", TO: "7", RS: "0.4", "T-ANGLE": "95", "P-ANGLE": "80" }],
    ],
    [
      "Italian and Spanish titles, arrows",
      "Utensile|Descrizione|Tipo|Orientamento|Raggio|Passo\n2|Filettatura|filettatura|↓|0,1|1,5\n",
      [{ T: "2", NAME: "Filettatura", TYPE: "THREAD", TO: "2", RS: "0.1", PITCH: "1.5" }],
    ],
    [
      "inch in the title, fractions, drills by diameter",
      'T,Name,Type,Diameter (in),Point angle,Flute length (inch)\n11,Drill,Drill,3/8",118,2.5\n12,Tap,Tap,.25,,1\n',
      [
        { T: "11", NAME: "Drill", TYPE: "DRILL", R: "4.7625", "T-ANGLE": "118", LCUTS: "63.5" },
        { T: "12", NAME: "Tap", TYPE: "TAP", R: "3.175", LCUTS: "25.4" },
      ],
    ],
    [
      "a heading above the titles, an unknown column, a code that fills the rest",
      "Werkzeugliste Halle 2;;;\n;;;\nWkz-Nr.;Bezeichnung;Wendeplatte;Lagerort\n4;Außen;CNMG 12 04 08;B12\n",
      [{ T: "4", NAME: "Außen", TYPE: "ROUGH", "P-ANGLE": "80", CUTLENGTH: "12.9", RS: "0.8" }],
    ],
    [
      "a line without a number",
      "Nr;Typ;Radius\n1;Schlichten;0,4\n;Schruppen;0,8\nT3;Schruppen;1,2\n",
      [
        { T: "1", TYPE: "FINISH", RS: "0.4" },
        { T: "2", TYPE: "ROUGH", RS: "0.8" },
        { T: "3", TYPE: "ROUGH", RS: "1.2" },
      ],
    ],
    [
      "limits of blades and bars",
      "Nr;Name;Typ;Breite;Stechtiefe;Abstech-⌀;Kleinste Bohrung;Abstützung\n1;A;Abstechen;3;20 mm;40;;gerade\n2;B;Bohrstange;;;;25;\n3;C;Stechen;4;;;;gebogen\n",
      [
        { T: "1", NAME: "A", TYPE: "RECESS", CUTWIDTH: "3", CDX: "20", CUTDIA: "40", SUPPORT: "STRAIGHT" },
        { T: "2", NAME: "B", TYPE: "ROUGH", DMIN: "25" },
        { T: "3", NAME: "C", TYPE: "RECESS", CUTWIDTH: "4", SUPPORT: "CURVED" },
      ],
    ],
  ])("%s", (_, text, rows) => expect(proposed(text)?.rows.map(({ cells }) => cells)).toEqual(rows));

  test("columns that are not assigned are named, and proposed numbers are told from written ones", () => {
    const made = proposed("Nr;Typ;Radius;Lagerort\n7;Schlichten;0,4;A1\n;Schruppen;0,8;\n");
    expect(made?.unused).toEqual(["Lagerort"]);
    expect(made?.rows.map(({ isNumbered }) => isNumbered)).toEqual([true, false]);
  });

  test("lines with the same number are named", () =>
    expect(proposed("Nr;Typ;Radius\n1;Schlichten;0,4\n1;Schruppen;0,8\n2;Schruppen;0,8\n")?.twice).toEqual(["1"]));

  test("a proposed number is free in the table, too", () => {
    const sheet = readSheet("Typ;Radius\nSchruppen;0,8\nSchlichten;0,4\n");
    const tools = sheet && toolsOfSheet(sheet, proposedAssignment(sheet), new Set([1, 3]));
    expect(tools?.rows.map(({ cells }) => cells.T)).toEqual(["2", "4"]);
  });

  test("each word keeps the value that was chosen for it, and a sheet is known again by its titles", () => {
    const sheet = readSheet("Nr;Art;Radius\n1;Spezial;0,8\n2;Form B;0,4\n");
    const columns = sheet
      ? proposedAssignment(sheet).columns.map((c, i) =>
          i === 1 ? { cell: "TYPE" as const, inch: false, diameter: false } : c,
        )
      : [];
    if (!sheet) throw new Error("no sheet");
    expect(wordsIn(sheet, { columns }, "TYPE")).toEqual(["Spezial", "Form B"]);
    const chosen = withWords(sheet, { columns, words: { TYPE: { Spezial: "BUTTON" }, TO: {} } });
    expect(chosen.words.TYPE).toEqual({ Spezial: "BUTTON", "Form B": "" });
    expect(toolsOfSheet(sheet, chosen).rows.map(({ cells }) => cells.TYPE)).toEqual(["BUTTON", "Form B"]);
    const same = readSheet("NR. ; art ;Radius [mm]\n9;Spezial;1\n");
    expect(same && signatureOf(same)).toBe(signatureOf(sheet));
  });

  test.each([
    ["Schruppen außen", "ROUGH"],
    ["Schlichtdrehmeißel", "FINISH"],
    ["Stechdrehen", "RECTURN"],
    ["Abstechhalter", "RECESS"],
    ["Gewindebohrer M8", "TAP"],
    ["Gewindedrehplatte", "THREAD"],
    ["NC-Anbohrer", "CENTER"],
    ["Bohrstange", "ROUGH"],
    ["Spiralbohrer", "DRILL"],
    ["Schaftfräser", "MILL"],
    ["button tool", "BUTTON"],
    ["rectrun", null],
    ["FINISH", "FINISH"],
    ["ébauche", "ROUGH"],
    ["丝锥", "TAP"],
  ])("type of %s", (word, type) => expect(typeOfWord(word)).toBe(type));

  test.each([
    ["3", 3],
    ["7,0", 7],
    ["↙", 1],
    ["-X -Z", 1],
    ["+Z/-X", 3],
    ["innen", 7],
    ["links außen", 3],
    ["axial", 8],
    ["10", null],
  ])("orientation of %s", (word, to) => expect(orientationOfWord(word)).toBe(to));

  test.each([["no sheet at all"], ["one,line"], [""], ["{}"], ["\u0000a;b\n1;2"]])("%j is no sheet", (text) =>
    expect(readSheet(text)).toBeNull(),
  );

  test("no text makes it throw", () =>
    fc.assert(
      fc.property(fc.oneof(fc.string(), fc.stringMatching(/^[A-Za-z;,\t"]{0,20}\n["A-Z0-9,;\t\n.]{0,80}$/)), (text) => {
        for (const { cells } of proposed(text)?.rows ?? []) readEntry({ id: "r", cells });
      }),
      { numRuns: 500, seed: 42 },
    ));
});

describe("workbooks", () => {
  const parts: Readonly<Record<string, string>> = {
    "xl/workbook.xml": `<workbook><sheets><sheet name="Leer" sheetId="1" r:id="rId1"/><sheet name="W&amp;Z" sheetId="2" r:id='rId2'/></sheets></workbook>`,
    "xl/_rels/workbook.xml.rels": `<Relationships><Relationship Target="worksheets/a.xml" Id="rId1"/><Relationship Id="rId2" Target="/xl/worksheets/b.xml"/></Relationships>`,
    "xl/sharedStrings.xml": `<sst><si><t>Nr</t></si><si><r><t>Rad</t></r><r><t xml:space="preserve">ius</t></r><rPh><t>no</t></rPh></si><si><t>Typ</t></si><si><t/></si></sst>`,
    "xl/worksheets/a.xml": `<worksheet><sheetData/></worksheet>`,
    "xl/worksheets/b.xml": `<x:worksheet><x:sheetData><x:row r="1"><x:c r="A1" t="s"><x:v>0</x:v></x:c><x:c r="B1" t="s"><x:v>1</x:v></x:c><x:c r="D1" t="s"><x:v>2</x:v></x:c></x:row><x:row r="2"><x:c r="A2"><x:v>1</x:v></x:c><x:c r="B2"><x:f>4/5</x:f><x:v>0.80000000000000004</x:v></x:c><x:c r="C2" s="1"/><x:c r="D2" t="inlineStr"><x:is><x:t>Schruppen &lt;au&#223;en&gt;</x:t></x:is></x:c></x:row></x:sheetData></x:worksheet>`,
  };
  test("the first sheet with titles is read: shared and own texts, gaps, saved results", () =>
    expect(sheetOfWorkbook((path) => parts[path] ?? null)).toEqual({
      titles: ["Nr", "Radius", "", "Typ"],
      lines: [["1", "0.8", "", "Schruppen <außen>"]],
    }));

  const openSheet = (rows: string) =>
    `<office:document-content><office:body><office:spreadsheet><table:table/><table:table>${rows}</table:table></office:spreadsheet></office:body></office:document-content>`;
  const EMPTY_ROWS = `<table:table-row table:number-rows-repeated="1048000"><table:table-cell table:number-columns-repeated="16384"/></table:table-row>`;
  const said = (text: string) =>
    `<table:table-cell office:value-type="string"><text:p>${text}</text:p></table:table-cell>`;
  const counted = (value: string, text: string) =>
    `<table:table-cell office:value-type="float" office:value="${value}"><text:p>${text}</text:p></table:table-cell>`;
  test.each([
    [
      "grouped rows, runs of text, saved numbers, notes left out",
      `<table:table-header-rows><table:table-row>${said("Nr")}${said("<text:span>Nose</text:span> <text:span>radius</text:span>")}${said("Typ<office:annotation><text:p>old</text:p></office:annotation>")}</table:table-row></table:table-header-rows>${EMPTY_ROWS}<table:table-row-group><table:table-row>${counted("1", "1")}${counted("0.80000000000000004", "0,8 mm")}${said("Schruppen<text:s/>außen")}</table:table-row></table:table-row-group>`,
      [["1", "0.8", "Schruppen außen"]],
    ],
    [
      "equal cells and rows are stored once",
      `<table:table-row>${said("Nr")}${said("Nose radius")}${said("Typ")}</table:table-row><table:table-row table:number-rows-repeated="2">${counted("4", "4").replace("<table:table-cell", `<table:table-cell table:number-columns-repeated="2"`)}<table:covered-table-cell/></table:table-row>`,
      [
        ["4", "4", ""],
        ["4", "4", ""],
      ],
    ],
  ])("a workbook of OpenDocument: %s", (_, rows, lines) =>
    expect(sheetOfWorkbook((path) => (path === "content.xml" ? openSheet(rows) : null))).toEqual({
      titles: ["Nr", "Nose radius", "Typ"],
      lines,
    }),
  );
  test("what is stored once for a thousand million rows or columns stays bounded", () => {
    const many = "1000000000";
    const rows = `<table:table-row>${said("Nr")}${said("Typ")}</table:table-row><table:table-row table:number-rows-repeated="${many}"><table:table-cell table:number-columns-repeated="${many}" office:value-type="float" office:value="1"/></table:table-row>`;
    const sheet = sheetOfWorkbook((path) => (path === "content.xml" ? openSheet(rows) : null));
    expect([sheet?.lines.length, sheet?.lines[0]?.length]).toEqual([MOST_LINES - 1, MOST_COLUMNS]);
  });
  test("without parts there is none, and no part makes it throw", () => {
    expect(sheetOfWorkbook(() => null)).toBeNull();
    const piece = fc.constantFrom(
      "<row>",
      "<c r='ZZ1' t='s'>",
      "<v>1",
      "</v>",
      "</c>",
      "&#x110000;",
      "<t",
      ">",
      "<",
      '"',
      "a",
      "<table>",
      "<table-row number-rows-repeated='1e9'>",
      "<table-cell number-columns-repeated='-3' value-type='float' value='NaN'>",
      "<p>b<s c='9e99'/>",
      "</p></table-cell>",
    );
    fc.assert(
      fc.property(fc.array(piece, { maxLength: 40 }), (pieces) => {
        sheetOfWorkbook(() => pieces.join(""));
      }),
      { numRuns: 300, seed: 42 },
    );
  });
});
