import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { main } from "../scripts/verify.ts";
import type { Report } from "../src/report/report.ts";

const program = (name: string) => `tests/programs/${name}.h`;
let [out, err, folder] = ["", "", ""];
const chunks: Buffer[] = [];

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), "verify-"));
  [out, err] = ["", ""];
  chunks.length = 0;
  vi.spyOn(process.stdout, "write").mockImplementation((data) => {
    chunks.push(Buffer.from(data));
    out = Buffer.concat(chunks).toString();
    return true;
  });
  vi.spyOn(process.stderr, "write").mockImplementation((data) => {
    err += String(data);
    return true;
  });
});
afterEach(() => {
  vi.restoreAllMocks();
  rmSync(folder, { recursive: true });
});

const file = (name: string, content: string | Buffer) => {
  const path = join(folder, name);
  writeFileSync(path, content);
  return path;
};
const reports = () =>
  out
    .trimEnd()
    .split("\n")
    .map((line) => JSON.parse(line) as Report);

describe("verify", () => {
  test("--control chooses how Z in an APPR is read: in the plane first, or all axes at once", () => {
    const lines = [
      "BEGIN PGM A MM",
      "BLK FORM 0.1 Z X+0 Y+0 Z-20",
      "BLK FORM 0.2 X+100 Y+100 Z+0",
      "TOOL CALL 20 Z S3000",
      "L X-20 Y-20 Z+5 R0 FMAX M3",
      "APPR LCT X+10 Y+20 Z-7.3 R10 RR F100",
      "L X+20 Y+35",
      "L Z+5 R0 FMAX",
      "M30",
      "END PGM A MM",
    ];
    const path = file("z.h", lines.map((line, i) => `${i} ${line}\n`).join(""));
    const depths = (control: string) => {
      chunks.length = 0;
      main([path, "--control", control, "--json"]);
      return reports()[0]
        ?.moves.filter((m) => m.block === 5)
        .map((m) => m.z);
    };
    const [plane, together] = [depths("tnc640"), depths("tnc7")];
    expect(plane?.at(-1)).toBe(-7.3);
    expect(together?.at(-1)).toBe(-7.3);
    expect(plane).toContain(5);
    expect(together).not.toContain(5);
    expect(main([path, "--control", "itnc530"])).toBe(2);
  });
  test("one JSON object a line and nothing else, status 0 without errors", () => {
    expect(main([program("shoulder-812"), program("groove-852"), "--json"])).toBe(0);
    const [first, second] = reports();
    expect([first?.file, second?.file]).toEqual([program("shoulder-812"), program("groove-852")]);
    expect(first?.format).toBe("turnwise-report/1");
    expect(first?.program).toEqual({ name: "SHOULDER812", unit: "mm", blocks: 13 });
    expect(first?.operations[0]).toMatchObject({
      block: 9,
      cycle: 812,
      start: { x: 75, z: 2 },
      tool: { T: 1, NAME: "CNMG-80-R08", TYPE: "ROUGH", TO: 1, RS: 0.8, "T-ANGLE": 95 },
    });
    expect(first?.proof.gouge).toBe(0);
    expect(first?.stock.initial).toEqual([
      [
        [-100, 0],
        [0, 0],
        [0, 37.5],
        [-100, 37.5],
      ],
    ]);
    expect(err).toBe("");
  });
  test("arcs carry their centre as a diameter, and a direction", () => {
    main([program("contour-820"), "--json"]);
    const arc = reports()[0]?.operations[0]?.moves.find((m) => m.kind === "arc");
    expect(arc).toMatchObject({
      kind: "arc",
      cx: expect.any(Number) as number,
      cz: expect.any(Number) as number,
      dir: expect.stringMatching(/^c?cw$/) as string,
    });
  });
  test("without --json a summary for people", () => {
    expect(main([program("shoulder-812")])).toBe(0);
    expect(out).toMatch(/cycle 812, tool 1 .*\n.*contour damage 0 mm².*\n.*0 errors/s);
  });
  test("an unknown cycle is reported by number and name, and nothing after its call is proved", () => {
    const cycle = ["CYCL DEF 317 BAR PULLER ~", "  Q1711=+31.7 ;PULL LENGTH", "L X+30 Z+1.5 R0 FMAX", "CYCL CALL"];
    const text = [
      "BEGIN PGM A MM",
      "BLK FORM CYLINDER Z D27 L61",
      "FUNCTION MODE TURN",
      "TOOL CALL 1",
      ...cycle,
      "END PGM A MM",
    ].join("\n");
    main([file("called.h", text), file("defined.h", text.replace("CYCL CALL\n", "")), "--json"]);
    const [called, defined] = reports();
    const unproved = "CYCL DEF 317 BAR PULLER";
    expect(called?.issues).toContainEqual(
      expect.objectContaining({ code: "notProved", text: expect.stringContaining(unproved) as string }),
    );
    expect(called?.issues).toContainEqual(
      expect.objectContaining({ code: "cycleNotSimulated", text: expect.stringContaining("317 BAR PULLER") as string }),
    );
    expect(JSON.stringify(called?.proof.unproved)).toContain(unproved);
    expect(defined?.issues.map(({ code }) => code)).not.toContain("notProved");
  });
  test("an error in a program is status 1, and its report is whole", () => {
    expect(main([program("shoulder-812"), program("bad/words"), "--json"])).toBe(1);
    expect(reports()[1]?.issues.some((i) => i.severity === "error" && i.block === 4 && i.text.length > 5)).toBe(true);
  });
  test.each([
    ["nothing", ""],
    ["binary", "\u0000\u0001\u0002"],
    ["endless", "LBL 1\nCALL LBL 1 REP 60000\nCALL LBL 1 REP 60000\n"],
  ])("%s is no crash", (_, text) => {
    expect(main([file("x.h", text), "--json"])).toBeLessThan(2);
    expect(reports()).toHaveLength(1);
  });
  test("a tools file replaces tools of the same number and adds others", () => {
    const tools = file(
      "t.json",
      JSON.stringify({
        tools: [{ T: 1, NAME: "MINE", TYPE: "ROUGH", TO: 1, RS: 0.4, "T-ANGLE": 95, "P-ANGLE": 80, CUTLENGTH: null }],
      }),
    );
    main([program("shoulder-812"), program("groove-852"), "--json", "--tools", tools]);
    expect(reports().map((r) => r.operations[0]?.tool["NAME"])).toEqual(["MINE", "FACE-RECTURN-3"]);
    expect(reports()[0]?.operations[0]?.tool).not.toHaveProperty("CUTLENGTH");
  });
  test("a tool with impossible columns is an error where it is called", () => {
    const tools = file("t.json", JSON.stringify({ tools: [{ T: 1, NAME: "X", TYPE: "ROUGH", TO: 1, RS: -1 }] }));
    expect(main([program("shoulder-812"), "--json", "--tools", tools])).toBe(1);
    expect(reports()[0]?.issues.map((i) => `${i.code} ${i.at} ${i.block}`)).toContain("toolColumn RS 3");
  });
  test("--machine: its times are in the report and the summary, which state their contents", () => {
    const machine = file(
      "m.json",
      JSON.stringify({ format: "turnwise-machine/1", name: "Lathe 7", rapid: { x: 9000, z: 12_500 }, toolChange: 3.7 }),
    );
    expect(main([program("shoulder-812"), "--json", "--machine", machine])).toBe(0);
    expect(reports()[0]?.time).toMatchObject({
      toolChange: 3.7,
      machine: "Lathe 7",
      contains: ["cutting", "rapid", "dwell", "toolChange"],
    });
    main([program("shoulder-812"), "--machine", machine]);
    expect(out).toMatch(
      / {2}time .* at X 9, Z 12\.5 m\/min, tool changes 0:04; machine Lathe 7, without acceleration, spindle run-up\n/,
    );
    chunks.length = 0;
    main([program("shoulder-812")]);
    expect(out).toMatch(
      / {2}time .* at 10 m\/min; no machine data, without acceleration, tool changes, spindle run-up\n/,
    );
  });
  test.each([
    ["not JSON", "{", "It is not JSON."],
    ["a tool file", '{"tools":[]}', "It is not a machine file."],
    ["a slip of units", '{"format":"turnwise-machine/1","name":"A","rapid":{"x":24,"z":30}}', "rapid.x: at least 100"],
  ])("broken machine file, %s: status 2", (_, text, why) => {
    const path = file("m.json", text);
    expect(main([program("shoulder-812"), "--machine", path])).toBe(2);
    expect(err).toBe(`verify: machine file ${path}: ${why}\n`);
  });
  test.each([
    ["no file", ["nowhere.h"]],
    ["nothing to do", []],
    ["an unknown option", [program("shoulder-812"), "--jason"]],
    ["no tools file", [program("shoulder-812"), "--tools", "nowhere.json"]],
  ])("%s: status 2 and one line of error", (_, args) => {
    expect(main([...args])).toBe(2);
    expect(out).toBe("");
    expect(err).toMatch(/^verify: .+\n$/);
  });
  test.each([
    ["not JSON", "{"],
    ["no table", "[]"],
    ["a wrong cell", '{"tools":[{"T":"one","TYPE":"ROUGH"}]}'],
    ["a wrong type", '{"tools":[{"T":1,"TYPE":"HAMMER"}]}'],
  ])("broken tools file, %s: status 2", (_, text) => {
    expect(main([program("shoulder-812"), "--tools", file("t.json", text)])).toBe(2);
    expect(err).toMatch(/^verify: tools file .+\n$/);
  });
  test("--print outputs the bytes of the file, in any encoding", () => {
    const latin = Buffer.from("0 BEGIN PGM A MM\r\n1 ; Fr\xe4sen \xd8\r\n2 END PGM A MM", "latin1");
    const path = file("l.h", latin);
    expect(main([path, program("layout-cam-de"), "--print"])).toBe(0);
    expect(Buffer.concat(chunks).equals(Buffer.concat([latin, readFileSync(program("layout-cam-de"))]))).toBe(true);
  });
});
