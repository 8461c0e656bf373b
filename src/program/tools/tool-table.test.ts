import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { insertOutline } from "../../kernel/cutter/insert.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { TOOL_TYPES } from "../../kernel/plan/tool.ts";
import { checkTool } from "./check-tool.ts";
import { soundHead } from "./holder-cells.ts";
import { readTools } from "./read-tools.ts";
import { shippedTools } from "./shipped-tools.ts";
import { drillOf } from "./drill-of.ts";
import { entryOf, readEntry, type MillTool, type ToolEntry } from "./tool-entry.ts";
import { freeNumber, mergedTools, newId, readList, sameList, shippedList } from "./tool-list.ts";
import { LONGEST_CELL } from "../files/bounded.ts";
import { readTableJson, readToolFile, writeTableJson } from "./tool-table-json.ts";
import { readTableText, writeMillText, writeTableText } from "./tool-table-text.ts";

const length = (min: number, max: number) => fc.integer({ min: min * 1e4, max: max * 1e4 }).map((n) => n / 1e4);
const angle = fc.integer({ min: 0, max: 179_999 }).map((n) => n / 1e3);
const cells = fc.record(
  {
    T: fc.integer({ min: 0, max: 32767 }),
    NAME: fc.stringMatching(/^[A-Z0-9#$%&,.-]{0,32}$/),
    TYPE: fc.constantFrom(...TOOL_TYPES),
    TO: fc.integer({ min: 1, max: 9 }),
    RS: length(0, 10),
    ZL: length(-999, 999),
    XL: length(-99999, 99999),
    DZL: length(-1, 1),
    DXL: length(-1, 1),
    DYL: length(-1, 1),
    DRS: length(-0.1, 1),
    ORI: fc.integer({ min: -360, max: 360 }),
    "T-ANGLE": angle,
    "P-ANGLE": angle,
    CUTLENGTH: length(1, 100),
    CUTWIDTH: length(0, 50),
    DCW: length(-0.5, 0.5),
  },
  { requiredKeys: ["T", "NAME", "TYPE", "TO", "RS"] },
);
/** A sound tool with the decimals that the control keeps. */
const tool = cells.filter((row) => checkTool(row).length === 0).map((row) => row as unknown as Tool);
const corner = fc.tuple(length(-50, 50), length(-50, 50));
const head = fc
  .array(fc.array(corner, { minLength: 3, maxLength: 6 }), { minLength: 1, maxLength: 3 })
  .filter(soundHead);
const holder = fc.record(
  {
    width: length(1, 50),
    length: length(1, 200),
    offsetZ: length(-50, 50),
    offsetX: length(-50, 50),
    axis: fc.constantFrom("X", "Z"),
    head,
  },
  { requiredKeys: ["width", "length", "offsetZ", "offsetX"] },
);
const limits = fc.record(
  {
    DAXN: length(1, 50),
    DAXX: length(50, 500),
    CDX: length(1, 50),
    CUTDIA: length(1, 100),
    DMIN: length(1, 100),
    SUPPORT: fc.constantFrom("NONE", "STRAIGHT", "CURVED"),
  },
  { requiredKeys: [] },
);
const withHolder = fc
  .tuple(tool, fc.option(holder), limits)
  .map(([t, h, l]) => ({ ...t, ...l, ...(h && { holder: h }) }) as unknown as Tool);
const table = (one: fc.Arbitrary<Tool>) => fc.uniqueArray(one, { selector: (t) => t.T, minLength: 1, maxLength: 12 });
const toolsOf = (rows: readonly ToolEntry["cells"][]) => rows.map((row) => readEntry({ id: "r", cells: row }).tool);

describe("a row of the table", () => {
  test("every tool is the tool of its row", () =>
    fc.assert(
      fc.property(withHolder, (t) => {
        expect(readEntry(entryOf(t, "r")).tool).toEqual(t);
      }),
      { numRuns: 400 },
    ));

  test("every row that is read as a tool can be drawn", () =>
    fc.assert(
      fc.property(
        fc.dictionary(
          fc.constantFrom(
            "T",
            "TYPE",
            "TO",
            "RS",
            "T-ANGLE",
            "P-ANGLE",
            "CUTLENGTH",
            "CUTWIDTH",
            "DRS",
            "DCW",
            "width",
          ),
          fc.oneof(
            fc.constantFrom(
              "",
              "0",
              "1",
              "-1",
              "8",
              "95",
              "179,9",
              "ROUGH",
              "THREAD",
              "BUTTON",
              "RECTURN",
              "RECESS",
              "x",
              "1e9",
              "2*3",
              "Q5",
            ),
            fc.string(),
          ),
        ),
        (row) => {
          const read = readEntry({ id: "r", cells: row });
          if (read.tool) {
            for (const p of insertOutline(read.tool, CHORD))
              expect(Number.isFinite(p.z) && Number.isFinite(p.r)).toBe(true);
          } else expect(read.issues.some((found) => found.severity === "error")).toBe(true);
        },
      ),
      { numRuns: 400 },
    ));

  const { holder: _, ...bare } = shippedTools[0] as Tool;
  const columnsOf = (change: ToolEntry["cells"]) =>
    readEntry({ id: "r", cells: { ...entryOf(bare, "r").cells, ...change } }).issues.map(
      (found) => `${found.at} ${found.code}`,
    );

  test.each<[ToolEntry["cells"], string[]]>([
    [{}, []],
    [{ RS: "0,8" }, []],
    [{ RS: "abc" }, ["RS notANumber"]],
    [{ RS: "-1" }, ["RS toolColumn"]],
    [{ RS: "" }, ["RS toolColumn"]],
    [{ T: "" }, ["T missing"]],
    [{ T: "40000" }, ["T toolColumn"]],
    [{ TO: "" }, ["TO toolColumn"]],
    [
      {
        TO: "11",
      },
      ["TO toolColumn"],
    ],
    [{ TO: "1.5" }, ["TO toolColumn"]],
    [{ "P-ANGLE": "85" }, ["P-ANGLE toolColumn"]],
    [{ "P-ANGLE": "" }, ["P-ANGLE flanksNotChecked"]],
    [{ TYPE: "THREAD", CUTLENGTH: "" }, ["CUTLENGTH toothAssumed"]],
    [{ TYPE: "THREAD", CUTLENGTH: "0" }, ["CUTLENGTH toothAssumed"]],
    [{ TYPE: "THREAD", CUTLENGTH: "2.5" }, []],
    [{ NAME: "a" }, ["NAME toolName"]],
    [{ NAME: "CNMG 80" }, ["NAME toolName"]],
    [{ NAME: "CNMG_80-R0.8#$%&," }, []],
    [{ TYPE: "BORE" }, ["TYPE toolColumn"]],
    [{ TYPE: "DRILL" }, ["R missing"]],
    [{ ORI: "361" }, ["ORI toolColumn"]],
    [
      {
        CUTLENGTH: "1/",
      },
      ["CUTLENGTH badExpression"],
    ],
    [{ width: "20" }, ["length missing"]],
    [{ width: "20", length: "100" }, []],
    [
      {
        width: "0",
        length: "100",
      },
      ["width toolColumn"],
    ],
    [{ width: "20", length: "9", axis: "z", head: "1/2,5 4/-3 2/.5; 0/0 1/0 0/1;" }, []],
    [{ axis: "Z" }, ["width missing", "length missing"]],
    [{ width: "20", length: "9", axis: "Y" }, ["axis holderAxis"]],
    [{ width: "20", length: "9", head: "1/2 2/3" }, ["head holderHead"]],
    [{ width: "20", length: "9", head: "0/0 1/1 2/2" }, ["head holderHead"]],
    [{ width: "20", length: "9", head: "0/0 1/1 2" }, ["head holderHead"]],
    [{ TYPE: "BUTTON", RS: "3", "P-ANGLE": "abc", CUTWIDTH: "x" }, []],
    [{ TYPE: "THREAD", "P-ANGLE": "0" }, ["P-ANGLE toolColumn"]],
  ])("%o: %s", (change, expected) => expect(columnsOf(change)).toEqual(expected));
});

describe("the list", () => {
  test("the shipped rows are the shipped tools", () =>
    expect(readList(shippedList).table).toEqual({ tools: shippedTools, refused: new Map() }));

  test("of two rows with one number the first keeps it, the second is offered a free one", () => {
    const twice = [...shippedList, { id: newId(shippedList), cells: { ...shippedList[0]?.cells } }];
    const { table: read, rows } = readList(twice);
    expect(read.tools).toEqual(shippedTools);
    expect(rows.get("r16")?.issues).toMatchObject([
      {
        code: "toolNumberTwice",
        severity: "error",
        at: "T",
        data: { number: 1, nearest: 16 },
      },
    ]);
    expect(rows.get("r1")).toMatchObject({
      tool: shippedTools[0],
      issues: [{ code: "toolNumberTwice", severity: "warning" }],
    });
  });

  test("a row with an error is refused with its reasons", () => {
    const broken = shippedList.map((entry) =>
      entry.id === "r3" ? { ...entry, cells: { ...entry.cells, RS: "-1" } } : entry,
    );
    const { table: read } = readList(broken);
    expect(read.tools).toHaveLength(14);
    expect([...read.refused]).toMatchObject([
      [3, [{ code: "toolColumn", at: "RS", data: { column: "RS", value: -1, nearest: 0 } }]],
    ]);
  });

  test("away from its row a finding names its column", () => {
    const cells = { ...shippedList[0]?.cells, T: "50", RS: "abc", length: "" };
    expect(readList([{ id: "a", cells }]).table.refused.get(50)).toMatchObject([
      { at: "RS", data: { column: "RS", value: null } },
      {
        at: "tool",
        data: { column: "holder.length", value: null },
      },
    ]);
  });

  test("rows of a file take the place of those with their number", () => {
    const rows = [
      { ...shippedList[2]?.cells, NAME: "NEW" },
      { ...shippedList[0]?.cells, T: "40" },
    ];
    const { list, replaced, added } = mergedTools(shippedList, rows);
    expect([list.length, replaced, added]).toEqual([16, 1, 1]);
    expect(list[2]).toEqual({ id: "r3", cells: rows[0] });
    expect(freeNumber(list)).toBe(16);
    expect(freeNumber(list, 39)).toBe(41);
    expect(sameList(list, shippedList)).toBe(false);
    expect(
      sameList(
        mergedTools(
          shippedList,
          shippedList.map((entry) => entry.cells),
        ).list,
        shippedList,
      ),
    ).toBe(true);
  });
});

describe("the tools file (JSON)", () => {
  test("read(write(tools)) is tools, here and for the verify command", () =>
    fc.assert(
      fc.property(table(withHolder), (tools) => {
        const text = writeTableJson(tools);
        const read = readTableJson(text);
        expect("rows" in read && toolsOf(read.rows)).toEqual(tools);
        expect(readTools(text)).toEqual({ tools, refused: new Map() });
      }),
      { numRuns: 300 },
    ));

  test("a wrong cell comes in as text", () => {
    const read = readToolFile(
      '{ "tools": [ { "T": 1, "NAME": "A", "TYPE": "ROUGH", "TO": "one", "RS": null, "COLOUR": 3, "holder": { "width": true } } ] }',
    );
    expect(read).toEqual({
      rows: [{ T: "1", NAME: "A", TYPE: "ROUGH", TO: "one", width: "true" }],
      leftOut: ["COLOUR"],
      cutShort: false,
    });
  });
});

describe("the control's column text", () => {
  test("read(write(tools)) is tools", () =>
    fc.assert(
      fc.property(table(tool), (tools) => {
        const read = readTableText(writeTableText(tools));
        expect("rows" in read && toolsOf(read.rows)).toEqual(tools);
      }),
      { numRuns: 400 },
    ));

  test("a name from another file begins no row and ends no table", () => {
    const names = ["A\r\n99      X", "B\n[END]", "C\tD", "[END]", "<b>"];
    const read = readTableText(
      writeTableText(names.map((NAME, i) => ({ ...shippedTools[0], T: i + 1, NAME }) as Tool)),
    );
    expect("rows" in read && read.rows.map(({ T, NAME }) => [T, NAME])).toEqual([
      ["1", "A 99      X"],
      ["2", "B [END]"],
      ["3", "C D"],
      ["4", "[END]"],
      ["5", "<b>"],
    ]);
  });

  test("what is finer than the columns is rounded once", () => {
    const text = writeTableText([{ ...shippedTools[0], RS: 0.79996, "T-ANGLE": 95.12345 } as Tool]);
    const read = readTableText(text);
    expect("rows" in read && toolsOf(read.rows)).toMatchObject([{ RS: 0.8, "T-ANGLE": 95.123 }]);
    expect(writeTableText(("rows" in read ? toolsOf(read.rows) : []) as Tool[])).toBe(text);
  });

  test("the shipped table", () =>
    expect(writeTableText(shippedTools)).toMatchInlineSnapshot(`
      "BEGIN TOOLTURN.TRN MM
      T       NAME                             ZL           XL           DZL          DXL          DYL          RS          DRS        TO  ORI       T-ANGLE  P-ANGLE  CUTLENGTH   CUTWIDTH    DCW          TYPE    
      1       CNMG-80-R08                                                                                       0.8                    1             95       80       12                                   ROUGH   
      2       DNMG-55-R08                                                                                       0.8                    1             93       55       12                                   ROUGH   
      3       DNMG-55-R04                                                                                       0.4                    1             93       55       12                                   FINISH  
      4       VNMG-35-R04                                                                                       0.4                    1             93       35       16                                   FINISH  
      5       BORE-CCMT-80-R04                                                                                  0.4                    7             95       80       9                                    ROUGH   
      6       BORE-DCMT-55-R04                                                                                  0.4                    7             93       55       9                                    FINISH  
      7       LEFT-DNMG-55-R08                                                                                  0.8                    3             93       55       12                                   ROUGH   
      8       FACE-RECTURN-3                                                                                    0.2                    8                               35          3                        RECTURN 
      9       OD-RECTURN-3                                                                                      0.2                    2                               30          3                        RECTURN 
      10      OD-RECESS-2                                                                                       0.1                    2                               20          2                        RECESS  
      11      BUTTON-R3                                                                                         3                      2                                                                    BUTTON  
      12      THREAD-60-OD                                                                                      0.1                    2                      60       2.5                                  THREAD  
      13      THREAD-60-ID                                                                                      0.1                    6                      60       2.5                                  THREAD  
      14      ID-RECTURN-2                                                                                      0.2                    6                               12          2                        RECTURN 
      15      FACE-DNMG-55-R08                                                                                  0.8                    1             120      55       12                                   ROUGH   
      [END]
      "
    `));

  test("a table of other widths, order and columns, with a description, comma and inches", () => {
    const text = [
      "BEGIN TOOLTURN.TRN INCH Version: 'Update:16.10'",
      "#STRUCTBEGIN",
      " NAME = T",
      "#STRUCTEND",
      "T   TYPE   RS      TO YL   NAME     CUTLENGTH",
      "7   rough  +0,0315 1  +0   LEFT ONE -",
      "8   FINISH 0.1x    3",
      "[END]",
      "behind",
    ].join("\n");
    expect(readToolFile(text)).toEqual({
      rows: [
        { T: "7", TYPE: "ROUGH", RS: "0.8001", TO: "1", NAME: "LEFT ONE", CUTLENGTH: "" },
        {
          T: "8",
          TYPE: "FINISH",
          RS: "0.1x",
          TO: "3",
        },
      ],
      leftOut: ["YL"],
      cutShort: false,
      columns: ["T", "TYPE", "RS", "TO", "NAME", "CUTLENGTH"],
      table: { milling: false, lines: [5, 6], turning: new Map() },
    });
  });

  test.each([
    ["", "notATable"],
    ["hello", "notATable"],
    ["{", "notATable"],
    ['{"tools":[]}', "noRows"],
    ['{"tools":[1]}', "notATable"],
    ["[]", "notATable"],
    ["BEGIN TOOL.T MM\nT NAME L R2\n1 A +0 +0\n[END]", "columnsMissing"],
    ["BEGIN TOOL.T MM\nT NAME L    R\n0      +0   +0\n[END]", "noRows"],
    ["BEGIN TOOLTURN.TRN MM\nT TYPE TO RS\n[END]", "noRows"],
    ["BEGIN TOOLTURN.TRN MM", "columnsMissing"],
  ])("%j: %s", (text, problem) => expect(readToolFile(text)).toMatchObject({ problem }));

  test.each([
    ["JSON", (long: string) => `{"tools":[{"T":1,"RS":${JSON.stringify(long)}}]}`],
    ["JSON with a list in a cell", (long: string) => `{"tools":[{"T":1,"RS":[${JSON.stringify(long)}]}]}`],
    ["a sheet", (long: string) => `T,RS,${long}\n1,${long},2`],
  ])("%s: no cell and no unknown column is longer than a stored one", (_, text) => {
    const read = readToolFile(text("9".repeat(100_000)));
    if (!("rows" in read)) throw new Error(read.problem);
    const texts = [...read.rows.flatMap((row) => Object.values(row)), ...read.leftOut];
    expect(Math.max(...texts.map(({ length }) => length))).toBe(LONGEST_CELL);
  });

  test("no text makes it throw", () =>
    fc.assert(
      fc.property(
        fc.oneof(
          fc.string(),
          fc.string().map((s) => `BEGIN TOOLTURN.TRN MM\nT TYPE TO RS NAME\n${s}`),
          fc.json(),
        ),
        (text) => {
          const read = readToolFile(text);
          if ("rows" in read) mergedTools(shippedList, read.rows).list.forEach((entry) => readEntry(entry));
        },
      ),
      { numRuns: 400 },
    ));

  test("a mutated file is still read or refused", () => {
    const text = writeTableText(shippedTools);
    fc.assert(
      fc.property(fc.nat(text.length), fc.nat(40), fc.string({ maxLength: 5 }), (at, cut, put) => {
        const read = readToolFile(text.slice(0, at) + put + text.slice(at + cut));
        if ("rows" in read) readList(mergedTools([], read.rows).list);
      }),
      { numRuns: 400 },
    );
  });
});

describe("milling tools", () => {
  const sizes = {
    T: fc.integer({ min: 0, max: 32767 }),
    NAME: fc.stringMatching(/^[A-Z0-9#$%&,.-]{1,32}$/),
    R: length(0, 100),
    L: length(-999, 999),
    DL: length(-9, 9),
    DR: length(0, 1),
  };
  const made = (of: Record<string, fc.Arbitrary<unknown>>) =>
    fc.record(of, { requiredKeys: ["T", "NAME", "R", "TYPE"] });
  const point = fc.integer({ min: 0, max: 180_000 }).map((n) => n / 1e3);
  const drills = { ...sizes, R: length(1, 100), LCUTS: length(0, 300) };
  const mill = fc.oneof(
    fc.record(sizes, { requiredKeys: ["T", "NAME", "R"] }),
    made({ ...drills, TYPE: fc.constantFrom("DRILL", "CENTER"), "T-ANGLE": point }),
    made({ ...drills, TYPE: fc.constant("TAP"), PITCH: length(0, 9) }),
  ) as fc.Arbitrary<MillTool>;
  const mills = fc.uniqueArray(mill, { selector: (m) => m.T, minLength: 1, maxLength: 12 });
  const millsOf = (rows: readonly ToolEntry["cells"][]) => rows.map((row) => readEntry({ id: "r", cells: row }).mill);

  test("read(write(mills)) is mills, as JSON and as text, and the verify command reads them", () =>
    fc.assert(
      fc.property(mills, (all) => {
        const json = writeTableJson([], all);
        const fromJson = readTableJson(json);
        expect("rows" in fromJson && millsOf(fromJson.rows)).toEqual(all);
        const fromText = readTableText(writeMillText(all));
        expect("rows" in fromText && millsOf(fromText.rows)).toEqual(all);
        const verified = readTools(json);
        expect("mills" in verified && verified.mills?.map(drillOf)).toEqual(all.map(drillOf));
        expect("mills" in verified && verified.mills?.map(({ T, R, DR }) => ({ T, R, DR }))).toEqual(
          all.map(({ T, R, DR }) => ({ T, R, DR: DR ?? 0 })),
        );
      }),
      { numRuns: 500 },
    ));

  test("a list of both kinds: programs get each, of one number only one", () => {
    const cells = { T: "20", NAME: "D16", TYPE: "MILL", R: "8", DR: "-0,02", L: "80" };
    const { table: read, mills: found } = readList([
      ...shippedList,
      { id: "m", cells },
      { id: "n", cells: { ...cells, T: "1" } },
    ]);
    expect(read).toMatchObject({ tools: shippedTools, mills: [{ T: 20, NAME: "D16", R: 8, DR: -0.02 }] });
    expect(found).toEqual([{ T: 20, NAME: "D16", R: 8, DR: -0.02, L: 80 }]);
  });

  test.each<[ToolEntry["cells"], string[]]>([
    [{ T: "1", R: "8" }, []],
    [{ T: "1" }, ["R missing"]],
    [{ R: "8" }, ["T missing"]],
    [
      {
        T: "1",
        R: "-1",
      },
      ["R toolColumn"],
    ],
    [{ T: "1", R: "1", DR: "-2" }, ["DR toolColumn"]],
    [{ T: "1", R: "a", L: "b" }, ["R notANumber", "L notANumber"]],
  ])("%o: %s", (cells, expected) =>
    expect(
      readEntry({ id: "m", cells: { ...cells, TYPE: "MILL" } }).issues.map((found) => `${found.at} ${found.code}`),
    ).toEqual(expected),
  );

  test.each<[ToolEntry["cells"], string[]]>([
    [{ TYPE: "DRILL", R: "4,25" }, []],
    [{ TYPE: "DRILL", R: "4.25", "T-ANGLE": "180" }, []],
    [{ TYPE: "DRILL", R: "4.25", "T-ANGLE": "180.5" }, ["T-ANGLE toolColumn"]],
    [{ TYPE: "CENTER", R: "0" }, ["R toolColumn"]],
    [{ TYPE: "CENTER", R: "3.15", DR: "-3.15" }, ["DR toolColumn"]],
    [{ TYPE: "TAP", R: "5", PITCH: "10" }, ["PITCH toolColumn"]],
    [{ TYPE: "TAP", R: "5", PITCH: "1.5", LCUTS: "-1", "T-ANGLE": "abc" }, ["LCUTS toolColumn"]],
    [{ TYPE: "DRILL", R: "5", PITCH: "abc", TO: "x" }, []],
    [{ TYPE: "MILL", R: "0", LCUTS: "abc" }, []],
    [{ TYPE: "DRILL", R: "5", PL: "3", "T-ANGLE": "118" }, []],
    [{ TYPE: "DRILL", R: "5", PL: "5", "T-ANGLE": "118" }, ["PL pointDiffers"]],
  ])("%o: %s", (cells, expected) =>
    expect(
      readEntry({ id: "d", cells: { T: "31", ...cells } }).issues.map((found) => `${found.at} ${found.code}`),
    ).toEqual(expected),
  );

  test("a drill of the table bores as what its columns say, and a mill does not", () => {
    const cells = { T: "31", TYPE: "DRILL", R: "4.25", DR: "-0.01", "T-ANGLE": "118", LCUTS: "0", PITCH: "2" };
    expect(readList([{ id: "d", cells }]).table.mills?.map(drillOf)).toMatchObject([
      { TYPE: "DRILL", R: 4.24, "T-ANGLE": 118 },
    ]);
    expect(readList([{ id: "d", cells }]).table.mills?.map(drillOf)[0]).not.toHaveProperty("CUTLENGTH");
    expect(readList([{ id: "d", cells: { ...cells, TYPE: "MILL" } }]).table.mills?.map(drillOf)).toEqual([null]);
  });

  test.each([
    ["5", 90],
    ["2.887", 120],
    ["0", undefined],
  ])("a point %s mm long on a drill of ⌀10 is one of %s°", (PL, angle) => {
    const [drill] =
      readList([{ id: "d", cells: { T: "31", TYPE: "DRILL", R: "5", PL } }]).table.mills?.map(drillOf) ?? [];
    expect(drill?.["T-ANGLE"] && Math.round(drill["T-ANGLE"] * 10) / 10).toBe(angle);
  });

  test("drills of a control's table are known by their word or their number, under either title", () => {
    const rows = (title: string, types: readonly string[]) =>
      readTableText(
        [
          "BEGIN TOOL.T INCH",
          `T  NAME R      ${title} LCUTS T-ANGLE PITCH  DOC`,
          ...types.map((type, i) => `${i + 1}  A    +0,125 ${type.padEnd(title.length)} 2     118     0,05`),
          "[END]",
        ].join("\r\n"),
      );
    const read = rows("TYPE  ", ["DRILL", "cent", "TAP", "MILL", "REAM", "TURN"]);
    expect("rows" in read && read.rows.map((row) => row.TYPE)).toEqual(["DRILL", "CENTER", "TAP", "MILL", "REAM"]);
    expect("rows" in read && read.rows[2]).toMatchObject({
      R: "3.175",
      LCUTS: "50.8",
      "T-ANGLE": "118",
      PITCH: "1.27",
    });
    const older = rows("TYP", ["1", "4", "2", "0", "3", "29"]);
    expect("rows" in older && older.rows.map((row) => row.TYPE)).toEqual(["DRILL", "CENTER", "TAP", "MILL", "REAM"]);
    expect("rows" in older && older.leftOut).toEqual(["DOC"]);
  });

  test("drills are written by the words of the control", () => {
    const text = writeMillText([
      { T: 1, NAME: "ZB", TYPE: "CENTER", R: 3.15, "T-ANGLE": 120 },
      {
        T: 2,
        NAME: "M10",
        TYPE: "TAP",
        R: 5,
        PITCH: 1.5,
        LCUTS: 22,
      },
      { T: 3, NAME: "F", R: 8 },
    ]);
    expect(text.split("\r\n").map((line) => line.split(/ +/).join(" ").trim())).toEqual([
      "BEGIN TOOL.T MM",
      "T NAME L R DL DR TYP LCUTS T-ANGLE PITCH",
      "1 ZB 3.15 CENT 120",
      "2 M10 5 TAP 22 1.5",
      "3 F 8 MILL",
      "[END]",
      "",
    ]);
  });

  test("a tool table of a control: empty places and turning tools are passed over, decimal commas read", () => {
    const text = [
      "BEGIN TOOL    .T       MM",
      "T    NAME             L          R          DL      DR      TYPE DOC",
      "0                     +0,000     +0,000     +0,000  +0,000  ",
      "5    14MM_CRB         -4,686     +7,000     +0,000  -0,425  MILL",
      "6    OD_ROUGH         +0,000     +0,000     +0,000  +0,000  TURN",
      "[END]",
      "",
    ].join("\r\n");
    const read = readToolFile(text);
    expect(read).toMatchObject({
      rows: [{ T: "5", NAME: "14MM_CRB", TYPE: "MILL", L: "-4.686", R: "7", DR: "-0.425" }],
      leftOut: ["DOC"],
    });
  });
});
