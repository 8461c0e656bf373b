import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { refusalText } from "../scripts/refusal-words.ts";
import { type FileReport, main } from "../scripts/verify.ts";
import { refusals } from "../src/control-file/refusals.ts";

let [folder, out, err] = ["", "", ""];

beforeEach(() => {
  [folder, out, err] = [mkdtempSync(join(tmpdir(), "verify-as-")), "", ""];
  vi.spyOn(process.stdout, "write").mockImplementation((data) => {
    out += String(data);
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

const file = (name: string, lines: readonly string[]) => {
  const path = join(folder, name);
  writeFileSync(path, `${lines.join("\r\n")}\r\n`);
  return path;
};
const reports = () =>
  out
    .trimEnd()
    .split("\n")
    .map((line) => JSON.parse(line) as FileReport);
const program = (...lines: readonly string[]) => [
  "0 BEGIN PGM A MM",
  "1 BLK FORM CYLINDER Z D50 L60",
  "2 FUNCTION MODE TURN",
  "3 TOOL CALL 1",
  ...lines,
  "9 END PGM A MM",
];
const LOOK = ["4 CYCL DEF 200  DRILLING", "Q200=+2 ;CLEARANCE", "Q201=-3 ;DEPTH"];

describe("verify --as", () => {
  test("names block, column and line of what the control refuses, below the summary, with status 1", () => {
    const path = file("look.h", program(...LOOK));
    expect(main([path, "--as", "tnc640"])).toBe(1);
    const last = out.trimEnd().split("\n").at(-1);
    expect(last).toBe(
      `${path}: a TNC 640 would not load it: block 4, column 1 (line 6): the list of CYCL DEF 200 has no " ~" at the end of the ` +
        "line before, so 2 lines become blocks of their own",
    );
    expect(main([path])).toBe(0);
  });
  test("each file has its own places in the report, empty where the control takes it", () => {
    const paths = [
      file("look.h", program(...LOOK)),
      file("file.h", program("4 CYCL DEF 200 DRILLING ~", "Q200=+2 ;CLEARANCE")),
    ];
    expect(main([...paths, "--as", "tnc7", "--json"])).toBe(1);
    const [look, whole] = reports();
    expect(look?.refused).toEqual([
      {
        block: 4,
        line: 6,
        column: 1,
        code: "listWithoutTilde",
        text: expect.stringContaining("CYCL DEF 200") as string,
      },
    ]);
    expect(whole?.refused).toEqual([]);
    expect(look?.format).toBe("turnwise-report/1");
  });
  test("without --as the report has no such field", () => {
    main([file("file.h", program("4 M3")), "--json"]);
    expect(reports()[0]).not.toHaveProperty("refused");
  });
  test("a file that the control takes keeps its status", () => {
    expect(main([file("file.h", program("4 M30")), "--as", "TNC640"])).toBe(0);
    expect(out).not.toContain("would not load");
  });
  test("Klartext is no DIN/ISO", () => {
    main([file("file.h", program("4 M30")), "--as", "iso", "--json"]);
    expect(reports()[0]?.refused?.map(({ code }) => code)).toContain("beginMissing");
  });
  test("the summary lists 20 of many refusals", () => {
    main([file("file.h", program(...Array.from({ length: 25 }, () => "LOOP"))), "--as", "tnc7"]);
    expect(out.match(/unknown word "LOOP"/g)).toHaveLength(20);
    expect(out).toMatch(/: a TNC7 would not load it: and 5 more\n$/);
  });
  test.each([
    ["another control", ["--as", "itnc530"]],
    ["nothing", ["--as"]],
  ])("%s: status 2", (_, args) => {
    expect(main([file("file.h", program()), ...args])).toBe(2);
    expect(err).toBe("verify: --as needs one of tnc640, tnc7, iso\n");
  });
  test("every refusal has its sentence", () => {
    const lines = [
      "LBL 1",
      "LBL 1",
      "L X",
      "L X--1",
      "L X1.1234567",
      "M1 M2 M3 M4 M5",
      "M1000",
      'LBL "',
      "Q1 = (",
      "Q1 = 2 2",
      "Q1 3",
      "1.5 L",
    ];
    const texts = [
      refusals(["BEGIN PGM A:B MM", ...lines, ...LOOK, "CYCL DEF 200 ~", "END PGM MM", "M3"].join("\n"), "tnc640"),
      refusals("M3", "tnc7"),
      refusals("%A\n%B G71 *", "iso"),
    ]
      .flat()
      .map(refusalText);
    expect(new Set(texts).size).toBeGreaterThan(17);
    expect(texts.filter((text) => text === "" || /undefined|NaN|\[object/.test(text))).toEqual([]);
  });
});
