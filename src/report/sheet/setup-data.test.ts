import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { setupData, type SetupData } from "./setup-data.ts";

const mills = [{ T: 41, NAME: "MILL-D7.5", R: 3.75 }];

function dataOf(text: string): SetupData {
  const program = parse(text);
  return setupData({
    program,
    run: run(program, { tools: shippedTools, mills, refused: new Map(), rapid: 7300 }),
    tools: shippedTools,
    mills,
  });
}

const flange = readFileSync(join("src", "examples", "flange.h"), "utf8");

const PART = `0 BEGIN PGM AWKWARD MM
1 BLK FORM CYLINDER Z D61.3 L47.7 DIST+1.7
2 FUNCTION MODE TURN
3 CYCL DEF 247 PRESETTING ~
Q339=+7 ;PRESET NUMBER
4 * - SHOULDER
5 TOOL CALL 1
6 FUNCTION TURNDATA SPIN VCONST:ON VC:187 SMAX2150
7 M136
8 L X+90.4 Z+33 R0 FMAX M303 M8
9 CYCL DEF 811 SHOULDER, LONGITDNL. ~
Q215=+0 ;MACHINING OPERATION ~
Q460=+1.8 ;SAFETY CLEARANCE ~
Q493=+43.7 ;DIAMETER AT CONTOUR END ~
Q494=-19.3 ;CONTOUR END IN Z ~
Q463=+2.9 ;MAX. CUTTING DEPTH ~
Q478=+0.27 ;ROUGHING FEED RATE ~
Q483=+0.3 ;OVERSIZE FOR DIAMETER ~
Q484=+0.1 ;OVERSIZE IN Z ~
Q505=+0.13 ;FINISHING FEED RATE ~
Q506=+0 ;CONTOUR SMOOTHING
10 L X+61.3 Z+1.8 FMAX
11 CYCL CALL
12 L X+90.4 Z+33 FMAX M9
13 TOOL CALL 977
14 L Z+60 FMAX
15 CALL PGM SECOND.H
16 TOOL CALL 1
17 L X+88 FMAX M8
18 M30
19 END PGM AWKWARD MM
`;

test("the flange: operations, tools in order of use, times that add up", () => {
  const data = dataOf(flange);
  expect(data.name).toBe("FLANGE");
  expect(data.operations.map(({ title }) => title)).toEqual([
    "FACING",
    "ROUGHING OUTSIDE",
    null,
    "FINISHING OUTSIDE",
    null,
    "ROUGHING THE BORE",
    "FINISHING THE BORE",
    "GROOVE IN THE FACE",
  ]);
  expect(data.tools.map(({ tool }) => tool?.T)).toEqual([15, 1, 3, 5, 6, 8]);
  expect(data.tools.every(({ spindle }) => spindle.join() === "303")).toBe(true);
  expect(data.toolChanges).toBe(6);
  expect(data.operations.reduce((sum, { seconds }) => sum + seconds, 0)).toBeCloseTo(data.seconds, 3);
  expect(data.operations.map(({ passes }) => passes)).toEqual([4, 7, 4, 0, 0, 4, 0, 6]);
});

test("awkward numbers: start, speed, feeds, preset", () => {
  const data = dataOf(PART);
  const [operation] = data.operations;
  expect(operation).toMatchObject({
    title: "SHOULDER",
    cycles: [811],
    tool: 0,
    start: { z: 1.8, r: 30.65 },
    spindle: { kind: "surface", cuttingSpeed: 187, limit: 2150 },
    isOff: false,
  });
  expect(operation?.feeds).toEqual([
    { value: 0.27, unit: "mm/rev" },
    { value: 0.13, unit: "mm/rev" },
  ]);
  expect(data.presets).toEqual(["7"]);
  expect(data.files).toEqual(["SECOND.H"]);
});

test("a tool called twice is listed once, with its M functions; one missing from the table is named", () => {
  const data = dataOf(PART);
  expect(data.tools.map(({ called, tool, mill }) => [called, tool?.T ?? null, mill])).toEqual([
    ["1", 1, null],
    ["977", null, null],
  ]);
  expect(data.tools[0]).toMatchObject({ spindle: [303], coolant: [8] });
  expect(data.toolChanges).toBe(3);
});

test("before the first run the data from the text is there, data from the run is not", () => {
  const data = setupData({ program: parse(PART), run: null, tools: shippedTools, mills });
  expect(data.name).toBe("AWKWARD");
  expect(data.operations[0]).toMatchObject({ title: "SHOULDER", start: null, spindle: null, passes: 0, seconds: 0 });
  expect(data.tools[0]?.tool?.T).toBe(1);
});

test("a program without anything", () => {
  expect(dataOf("")).toMatchObject({ name: "", operations: [], tools: [], seconds: 0, files: [], shifts: [] });
});

test("a milled program has its mill and its feeds", () => {
  const data = dataOf(`0 BEGIN PGM PLATE MM
1 TOOL DEF 41 L+103.7 R+3.75
1 TOOL CALL 41 Z S3150 F640
2 L X-20.5 Y+3 R0 FMAX M3
3 L X+50 F640
4 L Y+31.2 F210
5 L Z+100 FMAX
6 M30
7 END PGM PLATE MM
`);
  expect(data.tools).toMatchObject([
    {
      called: "41",
      tool: null,
      mill: { NAME: "MILL-D7.5" },
      spindle: [3],
      defined: { length: 103.7, radius: 3.75 },
    },
  ]);
  expect(data.operations[0]?.spindle).toEqual({ kind: "constant", speed: 3150 });
  expect(data.operations[0]?.feeds).toEqual([
    { value: 640, unit: "mm/min" },
    { value: 210, unit: "mm/min" },
  ]);
});

test("unknown cycles are named", () => {
  expect(dataOf(PART.replace("811 SHOULDER, LONGITDNL.", "1999 OWN")).unknownCycles).toEqual([1999]);
});

test("a program in inches says so before it runs, and its box is in mm like all the rest", () => {
  const program = parse(`0 BEGIN PGM BOX INCH
1 BLK FORM 0.1 Z X-1 Y-0.5 Z-0.75
2 BLK FORM 0.2 X+1 Y+0.5 Z+0
3 END PGM BOX INCH
`);
  const { unit, name, box } = setupData({ program, run: null, tools: [], mills: [] });
  expect({ unit, name }).toEqual({ unit: "inch", name: "BOX" });
  expect(box?.map((size) => size.toFixed(3))).toEqual(["50.800", "25.400", "19.050"]);
});
