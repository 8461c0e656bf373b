import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { part21Text } from "./part21-text.ts";
import { enumerationIn, listIn, numberIn, recordOf, referenceIn, textIn } from "./part21-values.ts";
import { isPart21, PART21_LIMITS, readPart21, type Part21Value } from "./part21.ts";

const file = (data: string, header = "FILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));") =>
  `ISO-10303-21;\nHEADER;\n${header}\nENDSEC;\nDATA;\n${data}\nENDSEC;\nEND-ISO-10303-21;\n`;
const valuesOf = (parameters: string) => readPart21(file(`#1=A(${parameters});`)).entities.get(1)?.[0]?.values;
const ref = (id: number): Part21Value => ({ kind: "reference", id });

test.each<readonly [string, readonly Part21Value[]]>([
  ["", []],
  ["1,-2.5,+3.E2,0.,.5,1.E-06", [1, -2.5, 300, 0, 0.5, 1e-6]],
  ["$,*,#12", [null, undefined, ref(12)]],
  [".T.,.MILLI.,.f.", ["T", "MILLI", "F"].map((name) => ({ kind: "enumeration", name }))],
  ["(1,(2,()),3)", [[1, [2, []], 3]]],
  ["'a''b',''", ["a'b", ""]],
  ["LENGTH_MEASURE(25.4)", [{ kind: "record", type: "LENGTH_MEASURE", values: [25.4] }]],
  ['"0FA"', [{ kind: "binary", digits: "0FA" }]],
  ["/* one; ' */ 1 , /**/ 'a /* b */ ; c' /* ) */", [1, "a /* b */ ; c"]],
  ["#1,\n  # 7", []],
])("parameters (%s)", (written, expected) => {
  if (written.includes("# ")) expect(valuesOf(written)).toBeUndefined();
  else expect(valuesOf(written)).toEqual(expected);
});

test.each([
  ["\\X\\D8", "Ø"],
  ["\\X2\\00D800E4\\X0\\x", "Øäx"],
  ["\\X2\\D83DDE00\\X0\\", "😀"],
  ["\\X4\\0001F600\\X0\\", "😀"],
  ["Stra\\S\\_e", "Straße"],
  ["\\PA\\\\S\\d", "ä"],
  ["\\PB\\\\S\\d", "\uFFFD"],
  ["C:\\\\Teile\\\\1", "C:\\Teile\\1"],
  ["two\r\n lines", "two lines"],
  ["a\\X2\\00Z8\\X0\\", "a\\X2\\00Z8\\X0\\"],
  ["\\X4\\FFFFFFFF\\X0\\", "\\X4\\FFFFFFFF\\X0\\"],
  ["a\\", "a\\"],
])("string %j is %j", (raw, text) => expect(part21Text(raw)).toBe(text));

describe("a file", () => {
  test("header, schema, complex entities, several data sections", () => {
    const read = readPart21(
      `/* by hand */ ISO-10303-21;
HEADER;
FILE_NAME('a.stp','2026-01-01',('me'),(''),'','CAD','');
FILE_SCHEMA(('automotive_design { 1 0 10303 214 }'));
ENDSEC;
ANCHOR; <a>=#1; ENDSEC;
DATA('one',('X'));
#1=(NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.)LENGTH_UNIT());
ENDSEC;
DATA;
#2 = cartesian_point ( '' , ( 1. , 2. , 3. ) ) ;
ENDSEC;
END-ISO-10303-21;
rubbish behind the end`,
    );
    expect(read.faults).toEqual([]);
    expect(read.schemas).toEqual(["AUTOMOTIVE_DESIGN { 1 0 10303 214 }"]);
    expect(read.header.map((r) => r.type)).toEqual(["FILE_NAME", "FILE_SCHEMA"]);
    expect(read.entities.get(1)?.map((r) => r.type)).toEqual(["NAMED_UNIT", "SI_UNIT", "LENGTH_UNIT"]);
    expect(recordOf(read.entities.get(2), "CARTESIAN_POINT")?.values).toEqual(["", [1, 2, 3]]);
  });

  test.each<readonly [string, string, readonly (readonly [string, number])[], readonly number[]]>([
    ["no such file", "0\nSECTION\n", [["notPart21", 0]], []],
    [
      "cut off",
      file("#1=A();\n#2=B(").slice(0, -30),
      [
        ["syntax", 7],
        ["cut", 0],
      ],
      [1],
    ],
    ["a wrong entity is left out alone", file("#1=A();\n#2=B(1 2);\n#3=C('x;');"), [["syntax", 7]], [1, 3]],
    ["a number twice", file("#1=A();\n#1=B();"), [["twice", 7]], [1]],
    [
      "numbers without end",
      file("#1=A(1E999);\n#2=A(1.2.3);"),
      [
        ["syntax", 6],
        ["syntax", 7],
      ],
      [],
    ],
    ["lists in lists without end", file(`#1=A(${"(".repeat(1e5)});`), [["tooDeep", 6]], []],
    ["a string without end", file("#1=A('x);\n#2=B();"), [["syntax", 6]], [2]],
  ])("%s", (_, text, faults, ids) => {
    const read = readPart21(text);
    expect(read.faults.map((f) => [f.code, f.line])).toEqual(faults);
    expect([...read.entities.keys()]).toEqual(ids);
  });

  test("faults are counted, but only the first are listed", () => {
    const read = readPart21(file("#1=A(;\n".repeat(50)));
    expect(read.faultCount).toBe(50);
    expect(read.faults.length).toBe(PART21_LIMITS.faults);
  });

  test("values by kind", () => {
    const values = valuesOf("#7,.T.,(1),L(2.5),L('x'),'y',3") ?? [];
    expect(values.map(referenceIn)).toEqual([7, null, null, null, null, null, null]);
    expect(values.map(enumerationIn)[1]).toBe("T");
    expect(values.map((v) => listIn(v).length)).toEqual([0, 0, 1, 0, 0, 0, 0]);
    expect(values.map(numberIn)).toEqual([null, null, null, 2.5, null, null, 3]);
    expect(values.map(textIn)).toEqual([null, null, null, null, "x", "y", null]);
  });
});

const piece = fc.constantFrom(
  "#",
  "1",
  "=",
  "A",
  "(",
  ")",
  ",",
  ";",
  "'",
  '"',
  ".",
  "T",
  "-",
  "$",
  "*",
  "/*",
  "*/",
  "\n",
  "\\X2\\",
  "ENDSEC;",
  "DATA;",
);
test("rubbish neither throws nor hangs", () => {
  fc.assert(
    fc.property(fc.array(piece, { maxLength: 60 }), fc.boolean(), (pieces, whole) => {
      const text = whole ? file(pieces.join("")) : `ISO-10303-21;HEADER;${pieces.join("")}`;
      const read = readPart21(text);
      expect(read.faults.length).toBeLessThanOrEqual(PART21_LIMITS.faults);
      expect(isPart21(text)).toBe(true);
    }),
    { numRuns: 300, seed: 21 },
  );
});
