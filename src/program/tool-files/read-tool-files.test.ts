import fc from "fast-check";
import { describe, expect, test } from "vitest";
import type { CellName } from "../tools/tool-columns.ts";
import type { ProposalReason } from "./facts.ts";
import type { NamedText } from "./foreign-file.ts";
import { TOOL_FILE_FORMATS } from "./formats.ts";
import { numbered, readToolFiles, type ForeignTools } from "./read-tool-files.ts";

const LINUXCNC = `; lathe
T1 P1 X+12.5 Z+3.2 D0.8 I95 J15 Q2 ;rough right
T2 P2 D0.8 I85 J25 Q2 ;finish
T3 P3 D0.8 I275 J335 Q3
T4 P4 D0.8 I265 J205 Q4
T6 P6 D0.1 I120 J60 Q6
T7 P7 D3 Q6 ;groove 3
T8 P8 D0.8 I95 J-15 Q3 ;boring bar
T9 P9 D6 Q9
T10 P10 Z40 D8.5 ;drill 8.5
`;
const fusion = (...data: readonly object[]) => JSON.stringify({ data, version: 1 });
const TURNING = {
  type: "turning general",
  unit: "millimeters",
  description: "OD rough",
  "post-process": { number: 1 },
  geometry: { RE: 0.8, SC: "C", INSD: 12.7, SIZE_SPECIFICATION_MODE: "IC", EPSR: 0 },
  holder: { HAND: "L", THSC: "L", W: 25, H: 25, CW: 32, LH: 32, OAL: 150 },
};
const HSM = `<?xml version="1.0"?><tool-library xmlns="http://www.hsmworks.com/xml/2004/cnc/tool-library" version="14">
<tool type="turning boring" unit="inches"><description>Bar</description><nc number="5"/>
<insert corner-radius="0.0157" diameter="0.375" shape="D"/>
<turning-holder style="boring bar U" hand="R" cutting-width="0.4" shank-width="0.625" head-length="1.25" overall-length="6"/></tool>
</tool-library>`;
const bit = (name: string, shape: string, parameter: object) =>
  JSON.stringify({ version: 2, name, shape: `${shape}.fcstd`, "shape-type": shape, parameter, attribute: {} });
const p21 = (item: string, ...values: readonly string[]) =>
  `ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('CUTTING_TOOL_SCHEMA_ARM'));\nENDSEC;\nDATA;
#1=ITEM($,'${item}',$);\n#2=UNIT('mm');\n#3=UNIT('inch');
${values.map((value, i) => `#${10 + i}=${value};`).join("\n")}\nENDSEC;\nEND-ISO-10303-21;\n`;
const number = (symbol: string, value: number, unit = "#2") => `NUMERICAL_VALUE('${symbol}',$,${unit},'${value}')`;
const HOLDER = p21(
  "DCLNR 2525M 12",
  number("KAPR", 95, "$"),
  number("B", 25),
  number("WF", 32),
  number("LF", 150),
  number("LH", 32),
  "STRING_VALUE('HAND','R')",
);
const INSERT = p21("CNMG 12 04 08", number("RE", 0.8), number("IC", 0.5, "#3"), "STRING_VALUE('SC','C')");
const din = (properties: Readonly<Record<string, string>>) =>
  `<Tool-Data><Tool><Properties>${Object.entries(properties)
    .map(
      ([name, value]) => `<Property-Data><PropertyName>${name}</PropertyName><Value>${value}</Value></Property-Data>`,
    )
    .join("")}</Properties></Tool></Tool-Data>`;

function foreignOf(...texts: readonly (string | NamedText)[]): ForeignTools {
  const files = texts.map((text, i) => (typeof text === "string" ? { name: `${i}`, text } : text));
  const [read] = readToolFiles(files, "mm");
  if (!read || !("foreign" in read.content)) throw new Error(JSON.stringify(read));
  return read.content.foreign;
}

type Cells = Readonly<Partial<Record<CellName, string>>>;
const CASES: readonly (readonly [what: string, text: string, cells: readonly Cells[]])[] = [
  [
    "LinuxCNC: orientations, angles of edges, offsets",
    LINUXCNC,
    [
      {
        T: "1",
        NAME: "ROUGH-RIGHT",
        TYPE: "ROUGH",
        TO: "1",
        RS: "0.4",
        "T-ANGLE": "85",
        "P-ANGLE": "80",
        ZL: "3.2",
        XL: "12.5",
      },
      { T: "2", NAME: "FINISH", TYPE: "FINISH", TO: "1", RS: "0.4", "T-ANGLE": "95", "P-ANGLE": "60" },
      { T: "3", TYPE: "ROUGH", TO: "7", RS: "0.4", "T-ANGLE": "95", "P-ANGLE": "60" },
      { T: "4", TYPE: "ROUGH", TO: "5", RS: "0.4", "T-ANGLE": "95", "P-ANGLE": "60" },
      { T: "6", TYPE: "THREAD", TO: "2", RS: "0.05", "P-ANGLE": "60" },
      { T: "7", NAME: "GROOVE-3", TYPE: "RECESS", TO: "2", CUTWIDTH: "3" },
      { T: "8", NAME: "BORING-BAR", TYPE: "ROUGH", TO: "7", RS: "0.4", "T-ANGLE": "95", "P-ANGLE": "70" },
      { T: "9", TYPE: "BUTTON", TO: "9", RS: "3" },
      { T: "10", NAME: "DRILL-8.5", TYPE: "DRILL", R: "4.25", L: "40" },
    ],
  ],
  [
    "Fusion: left-hand holder with its shank",
    fusion(TURNING),
    [
      {
        ...{ T: "1", NAME: "OD-ROUGH", TYPE: "ROUGH", TO: "3", RS: "0.8", "T-ANGLE": "95", "P-ANGLE": "80" },
        ...{ CUTLENGTH: "12.9", width: "25", length: "118", offsetZ: "-7", offsetX: "32" },
      },
    ],
  ],
  [
    "Fusion: grooving inside, threading, tap and drill in inches",
    fusion(
      {
        type: "turning grooving",
        unit: "millimeters",
        geometry: { tool_grooveWidth: 3, RE: 0.2 },
        holder: { THSC: "groove internal" },
      },
      { type: "turning threading", unit: "millimeters", geometry: { "thread-profile-angle": 55, RE: 0 } },
      { type: "tap right hand", unit: "inches", geometry: { DC: 0.25, TP: 0.05, LCF: 1 } },
      { type: "drill", unit: "millimeters", geometry: { DC: 8.5, SIG: 140, LCF: 47 } },
    ),
    [
      { NAME: "TURNING-GROOVING", TYPE: "RECESS", TO: "6", RS: "0.2", CUTWIDTH: "3" },
      { NAME: "TURNING-THREADING", TYPE: "THREAD", TO: "2", RS: "0", "P-ANGLE": "55" },
      { NAME: "TAP-RIGHT-HAND", TYPE: "TAP", R: "3.175", LCUTS: "25.4", PITCH: "1.27" },
      { NAME: "DRILL", TYPE: "DRILL", R: "4.25", "T-ANGLE": "140", LCUTS: "47" },
    ],
  ],
  [
    "Fusion: shanks of a left-hand blade, a thread tool and a grooving bar",
    fusion(
      ...(
        [
          ["turning grooving", "groove external", "L", { tool_grooveWidth: 3 }, 32],
          ["turning threading", "external", "R", { "thread-profile-angle": 60 }, 32],
          ["turning grooving", "groove internal", "R", { tool_grooveWidth: 2 }, 17],
        ] as const
      ).map(([type, THSC, HAND, geometry, CW]) => ({
        type,
        unit: "millimeters",
        geometry: { RE: 0.2, ...geometry },
        holder: { THSC, HAND, W: 25, CW, LH: 30, OAL: 150 },
      })),
    ),
    [
      {
        ...{ NAME: "TURNING-GROOVING", TYPE: "RECESS", TO: "2", RS: "0.2", CUTWIDTH: "3" },
        ...{ width: "25", length: "120", offsetZ: "-32", offsetX: "30" },
      },
      {
        ...{ NAME: "TURNING-THREADING", TYPE: "THREAD", TO: "2", RS: "0.2", "P-ANGLE": "60" },
        ...{ width: "25", length: "120", offsetZ: "7", offsetX: "30" },
      },
      {
        ...{ NAME: "TURNING-GROOVING", TYPE: "RECESS", TO: "6", RS: "0.2", CUTWIDTH: "2" },
        ...{ width: "25", length: "120", offsetZ: "30", offsetX: "-4.5" },
      },
    ],
  ],
  [
    "HSMWorks: bar in inches",
    HSM,
    [
      {
        ...{ T: "5", NAME: "BAR", TYPE: "ROUGH", TO: "7", RS: "0.3988", "T-ANGLE": "93", "P-ANGLE": "55" },
        ...{ CUTLENGTH: "11.63", width: "15.875", length: "120.65", offsetZ: "31.75", offsetX: "-2.2225" },
      },
    ],
  ],
  [
    "FreeCAD: a bit with units of its own",
    bit("Tap", "tap", { Diameter: '0.375 "', Pitch: "1.25 mm", Length: "79 mm" }),
    [{ NAME: "TAP", TYPE: "TAP", R: "4.7625", PITCH: "1.25" }],
  ],
  [
    "ISO 13399: axial groove with the limits of the blade",
    p21("R123", number("CW", 3), number("RE", 0.2), number("CDX", 18), number("DAXN", 40), number("DAXX", 60)),
    [{ NAME: "R123", TYPE: "RECESS", TO: "8", RS: "0.2", CUTWIDTH: "3", CDX: "18", DAXN: "40", DAXX: "60" }],
  ],
  [
    "ISO 13399: a holder alone, its insert from its code",
    HOLDER,
    [
      {
        ...{ NAME: "DCLNR-2525M-12", TYPE: "ROUGH", TO: "1", "T-ANGLE": "95", "P-ANGLE": "80", CUTLENGTH: "12.9" },
        ...{ width: "25", length: "118", offsetZ: "7", offsetX: "32" },
      },
    ],
  ],
  [
    "DIN 4000: drill, tap, end mill, centre drill",
    din({ NSM: "DIN4000-81", BLD: "1", J22: "Drill", A11: "8,5", E1: "140", B6: "47", B7: "1,5" }).replace(
      "</Tool-Data>",
      din({ NSM: "DIN4000-80", BLD: "2", J22: "Tap", A1: "M", A21: "6", A3: "1" }).replace("<Tool-Data>", ""),
    ),
    [
      { NAME: "DRILL", TYPE: "DRILL", R: "4.25", "T-ANGLE": "140", LCUTS: "47", PL: "1.5" },
      { NAME: "TAP", TYPE: "TAP", R: "3", PITCH: "1" },
    ],
  ],
  [
    "a sheet with the letters of DIN 4000",
    'J21;NSM;BLD;A1;B2;J8\n6767;DIN4000-82;2;1.588;3.175;"FZI,FSE"\n',
    [{ NAME: "6767", TYPE: "MILL", R: "0.794" }],
  ],
  [
    "a list of properties as a maker's page shows it",
    "Name\tDescription\tValue\nItemNumber\tItem\tA20 SDUCL\nRE\tCorner radius\t0.40 mm\nIC\tCircle\t9.525 mm\nSC\tShape\tD\nKAPR\tAngle\t93 deg\nHAND\tHand\tL\nDMIN1\tSmallest bore\t25 mm\n",
    [
      {
        ...{ NAME: "A20-SDUCL", TYPE: "ROUGH", TO: "7", RS: "0.4", "T-ANGLE": "93", "P-ANGLE": "55" },
        ...{ CUTLENGTH: "11.63", DMIN: "25" },
      },
    ],
  ],
  [
    "the sheet that Fusion exports, a row for each preset",
    '"Type (tool_type)"\t"Description (tool_description)"\t"Number (tool_number)"\t"Unit (tool_unit)"\t"Diameter (tool_diameter)"\n"drill"\t"D5"\t4\t"inches"\t0.25\n"drill"\t"D5"\t4\t"inches"\t0.25\n',
    [{ T: "4", NAME: "D5", TYPE: "DRILL", R: "3.175" }],
  ],
];

test.each(CASES)("%s", (_, text, cells) => {
  expect(foreignOf(text).tools.map((tool) => tool.cells)).toEqual(cells);
});

test("every format of other systems has a case", () => {
  const found = new Set(CASES.map(([, text]) => foreignOf(text).format));
  const foreign = Object.entries(TOOL_FILE_FORMATS).flatMap(([name, format]) => ("foreign" in format ? [name] : []));
  expect([...found].sort()).toEqual(foreign.sort());
});

describe("proposals", () => {
  const why = (text: string, cell: CellName, at = 0): readonly ProposalReason[] | undefined =>
    foreignOf(text).tools[at]?.origins[cell]?.why;

  test.each<readonly [string, CellName, number, readonly ProposalReason[]]>([
    [LINUXCNC, "TO", 0, []],
    [LINUXCNC, "TYPE", 0, ["kindFromName"]],
    [LINUXCNC, "TYPE", 4, ["wedgeFromAngles"]],
    [LINUXCNC, "CUTWIDTH", 5, ["widthFromDiameter"]],
    [LINUXCNC, "T-ANGLE", 6, ["edgeTurned"]],
    [fusion(TURNING), "TO", 0, []],
    [fusion({ ...TURNING, holder: {}, description: "" }), "TO", 0, ["outsideAssumed", "handAssumed"]],
    [fusion({ ...TURNING, holder: {}, description: "ID finish" }), "TO", 0, ["sideFromName", "handAssumed"]],
    [fusion({ ...TURNING, type: "turning boring", holder: { HAND: "L" } }), "TO", 0, ["leftBar"]],
    [fusion({ type: "turning grooving", unit: "millimeters", geometry: { CW: 2 } }), "TYPE", 0, ["recessAssumed"]],
    [fusion({ type: "turning parting", unit: "millimeters", geometry: { CW: 2 } }), "TYPE", 0, []],
    [HSM, "CUTLENGTH", 0, ["circleAssumed"]],
    [HOLDER, "P-ANGLE", 0, ["fromCode"]],
    [fusion({ type: "turning threading", unit: "millimeters", description: "16ER AG60" }), "P-ANGLE", 0, ["fromCode"]],
    [fusion({ type: "turning grooving", unit: "millimeters", description: "MGMN300" }), "CUTWIDTH", 0, ["fromCode"]],
    [din({ NSM: "DIN4000-81", BLD: "7", A11: "4", A11_2: "10", E4_2: "60" }), "R", 0, ["bodyAsCentre"]],
  ])("%#", (text, cell, at, reasons) => {
    expect(why(text, cell, at)).toEqual(reasons);
  });

  test("a value names the property it stands in, with the unit of its file", () => {
    const [bar] = foreignOf(HSM).tools;
    expect(bar?.origins.RS).toEqual({ from: "insert.corner-radius 0.0157 in", why: [] });
    expect(foreignOf(fusion(TURNING)).tools[0]?.origins.CUTLENGTH?.from).toBe("INSD 12.7, SC C");
  });
});

test("an insert and a holder in two files are one tool", () => {
  const { tools } = foreignOf(HOLDER, INSERT);
  expect(tools.map((tool) => tool.cells)).toEqual([
    expect.objectContaining({
      NAME: "CNMG-12-04-08",
      RS: "0.8",
      "T-ANGLE": "95",
      CUTLENGTH: "12.9",
      width: "25",
    }),
  ]);
  expect(
    readToolFiles(
      [HOLDER, INSERT, INSERT].map((text, i) => ({ name: `${i}`, text })),
      "mm",
    ),
  ).toHaveLength(3);
});

test("a library of FreeCAD numbers the bits that were chosen with it, and names the others", () => {
  const library = JSON.stringify({
    tools: [
      { nr: 4, path: "Bit/A.fctb" },
      { nr: 7, path: "b.fctb" },
    ],
    version: 1,
  });
  const { tools, refused } = foreignOf(
    { name: "a.fctb", text: bit("CCMT", "isoshape", { TipRadius: "0.4 mm", TipAngle: "80 °", EdgeLength: "6.35 mm" }) },
    { name: "lathe.fctl", text: library },
  );
  expect(tools[0]?.cells).toMatchObject({ T: "4", TYPE: "ROUGH", RS: "0.4", "P-ANGLE": "80", CUTLENGTH: "6.35" });
  expect(refused).toEqual([{ label: "T7", why: "fileMissing", kind: "b.fctb" }]);
});

test.each<readonly [string, string]>([
  [fusion({ type: "probe", description: "P" }), "probe"],
  [fusion({ type: "holder", description: "ER32" }), "holder"],
  [fusion({ type: "laser cutter", description: "L" }), "otherMachine"],
  [fusion({ type: "counter bore", description: "C" }), "noColumn"],
  [bit("Probe", "probe", { Diameter: "6 mm" }), "probe"],
  [din({ NSM: "DIN4000-76", BLD: "1", A1: "12" }), "unknownList"],
  [p21("X", number("OAL", 60)), "kindUnknown"],
  [p21("X"), "nothingKnown"],
])("refused: %#", (text, why) => {
  const { tools, refused } = foreignOf(text);
  expect([tools.length, refused.map((item) => item.why)]).toEqual([0, [why]]);
});

test("the unit is asked for only where a file has none, and then counts", () => {
  const units = (text: string) => readToolFiles([{ name: "", text }], "inch")[0]?.content;
  expect(units(LINUXCNC)).toMatchObject({
    foreign: { assumedUnit: "inch", tools: [{ cells: { RS: "10.16", ZL: "81.28" } }, ...Array(8).fill({})] },
  });
  expect(units(fusion(TURNING))).toMatchObject({ foreign: { assumedUnit: null } });
});

test("tools without a number, or with one that an earlier tool has, get the next free one", () => {
  const { tools } = foreignOf(fusion(TURNING, TURNING, { ...TURNING, "post-process": { number: 0 } }));
  const made = numbered(tools, new Set([2, 3]));
  expect(made.map(({ cells, origins }) => [cells.T, origins.T?.why])).toEqual([
    ["1", []],
    ["4", ["numberTaken"]],
    ["5", ["numberFree"]],
  ]);
});

test.each(['{ "tools": [{ "T": 1, "TYPE": "ROUGH", "TO": 1, "RS": 0.8 }] }', "T;NAME;TYPE;TO;RS\n1;A;ROUGH;1;0.8\n"])(
  "files of this app stay with their readers: %s",
  (text) => {
    expect(readToolFiles([{ name: "", text }], "mm")[0]?.content).toMatchObject({
      table: { rows: [{ T: "1", RS: "0.8" }] },
    });
  },
);

describe("any text", () => {
  const mutated = fc
    .tuple(fc.constantFrom(...CASES.map(([, text]) => text)), fc.nat(400), fc.nat(40), fc.string({ maxLength: 20 }))
    .map(([text, at, cut, put]) => text.slice(0, at) + put + text.slice(at + cut));
  const hostile = fc.constantFrom(
    `{"data":${"[".repeat(5000)}`,
    fusion({ type: "turning general", geometry: { RE: 1e308, SC: {}, INSD: "9".repeat(500) }, holder: { HAND: 5 } }),
    `T1 ${"D1 ".repeat(2000)}`,
    `${"<Tool-Data>".repeat(500)}`,
    p21("X", "NUMERICAL_VALUE('RE',$,#10,#10)", "MULTI_LANGUAGE_STRING((#11),#11)"),
    JSON.stringify({ tools: [{ nr: 1, path: "" }] }),
    `NSM\n${"DIN4000-81\n".repeat(300)}`,
  );

  test("is read or refused, with cells of a bounded length", () => {
    fc.assert(
      fc.property(fc.oneof(mutated, hostile, fc.string()), (text) => {
        for (const { content } of readToolFiles(
          [
            { name: "x", text },
            { name: "x", text },
          ],
          "mm",
        )) {
          if (!("foreign" in content)) continue;
          for (const { cells, label } of content.foreign.tools) {
            expect(Object.values(cells).every((cell) => cell.length < 100)).toBe(true);
            expect(label.length).toBeLessThan(500);
            expect(cells.TYPE).toBeTruthy();
          }
        }
      }),
      { numRuns: 150, seed: 41 },
    );
  });
});
