import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { main } from "../scripts/verify.ts";
import type { Report } from "../src/report/report.ts";

let [folder, out] = ["", ""];

beforeEach(() => {
  [folder, out] = [mkdtempSync(join(tmpdir(), "verify-files-")), ""];
  vi.spyOn(process.stdout, "write").mockImplementation((data) => {
    out += String(data);
    return true;
  });
});
afterEach(() => {
  vi.restoreAllMocks();
  rmSync(folder, { recursive: true });
});

const numbered = (lines: readonly string[]) => lines.map((line, i) => `${i} ${line}\n`).join("");
const turned = (lines: readonly string[], name = "MAIN") =>
  numbered([
    `BEGIN PGM ${name} MM`,
    "BLK FORM CYLINDER Z D80 L100 DIST+1",
    "TOOL CALL 1",
    "FUNCTION MODE TURN",
    "FUNCTION TURNDATA SPIN " + "VCONST:OFF S500",
    "M136",
    "L X+91.3 Z+40.7 R0 FMAX",
    ...lines,
    "M30",
    `END PGM ${name} MM`,
  ]);
const called = (lines: readonly string[]) => numbered(["BEGIN PGM SUB MM", ...lines, "END PGM SUB MM"]);
const file = (name: string, content: string) => {
  const path = join(folder, name);
  writeFileSync(path, content);
  return path;
};

interface Ran {
  readonly status: number;
  readonly places: readonly string[];
  readonly codes: readonly string[];
  readonly unproved: readonly string[];
}
const ran = (...args: string[]): Ran => {
  out = "";
  const status = main([...args, "--json"]);
  const report = JSON.parse(out.split("\n")[0] ?? "") as Report;
  return {
    status,
    places: report.moves.map((m) => `${m.x} ${m.z}`),
    codes: report.issues.filter((i) => i.severity !== "info").map((i) => i.code),
    unproved: report.proof.unproved.map((u) => u.what),
  };
};

describe("programs in the folder of the program", () => {
  const SUB = called(["L X+83.9 FMAX"]);
  test.each([
    ["in quotes", 'CALL PGM "SUB.H"', "SUB.H"],
    ["bare", "CALL PGM SUB.H", "SUB.H"],
    ["without an ending", "CALL PGM SUB", "SUB.H"],
    ["small letters in the program", "CALL PGM sub.h", "SUB.H"],
    ["small letters on the disk", 'CALL PGM "SUB.H"', "sub.h"],
    ["an ending in small letters", "CALL PGM Sub", "SUB.h"],
    ["a path of the control", "CALL PGM TNC:\\nc_prog\\parts\\SUB.H", "SUB.H"],
    ["a path of the control in quotes, without an ending", 'CALL PGM "TNC:\\nc_prog\\sub"', "Sub.H"],
    ["a path up and down", "CALL PGM ..\\other\\SUB.H", "SUB.H"],
    ["a blank in the name", 'CALL PGM "TNC:\\work\\MY SUB.H"', "My Sub.h"],
    ["chosen before", 'SEL PGM "TNC:\\SUB.H"\nCALL SELECTED PGM', "sub.h"],
    ["by a text", 'QS1 = "TNC:\\" || "sub"\nCALL PGM QS1', "SUB.H"],
    ["cycle 12", "CYCL DEF 12.0 PGM CALL\nCYCL DEF 12.1 PGM TNC:\\x\\SUB\nCYCL CALL", "SUB.H"],
  ])("%s", (_, lines, name) => {
    file(name, SUB);
    expect(ran(file("main.h", turned(lines.split("\n"))))).toEqual({
      status: 0,
      places: ["83.9 40.7"],
      codes: [],
      unproved: [],
    });
  });
  test.each([
    ["nothing of that name", "SUB1.H"],
    ["another kind of file", "SUB.I"],
  ])("one that is missing: %s", (_, name) => {
    file(name, SUB);
    const r = ran(file("main.h", turned(["CALL PGM SUB", "L IZ-1 FMAX"])));
    // Where the tool was moved before, and nowhere after.
    expect(r).toEqual({ status: 0, places: ["91.3 40.7"], codes: ["notProved"], unproved: ["CALL PGM"] });
  });
  test("a folder of that name is no program", () => {
    mkdirSync(join(folder, "SUB.H"));
    expect(ran(file("main.h", turned(["CALL PGM SUB"]))).unproved).toEqual(["CALL PGM"]);
  });
  test("the program's folder takes precedence over files from the command line", () => {
    mkdirSync(join(folder, "far"));
    const far = file("far/SUB.H", called(["L X+61.7 FMAX"]));
    const path = file("main.h", turned(["CALL PGM SUB"]));
    expect(ran(path, far).places.at(-1)).toBe("61.7 40.7");
    file("SUB.H", SUB);
    expect(ran(path, far).places.at(-1)).toBe("83.9 40.7");
  });
  test("a contour in a file, named in either way", () => {
    const cycle =
      "CYCL DEF 820 TURN CONTOUR TRANSV. ~\nQ215=+0 ~\nQ460=+2 ~\nQ499=+0 ~\nQ463=+2 ~\nQ478=+0.3 ~\nQ483=+0 ~\nQ484=+0 ~\n" +
      "Q505=+0.2 ~\nQ487=+1 ~\nQ488=+0 ~\nQ479=+0 ~\nQ480=+0 ~\nQ482=+0 ~\nQ506=+0";
    file("outline.H", called(["L X+80 Z-20.5", "L X+50", "L Z+0"]));
    for (const block of ['SEL CONTOUR "TNC:\\c\\OUTLINE"', 'CONTOUR DEF P1 = "outline.h"']) {
      out = "";
      main([file("main.h", turned(["TOOL CALL 15", block, cycle, "L X+82 Z+3 FMAX", "CYCL CALL"])), "--json"]);
      expect((JSON.parse(out) as Report).operations[0]?.contour).toEqual([
        [-20.5, 40],
        [-20.5, 25],
        [0, 25],
      ]);
    }
  });
  test("a program that calls itself ends with a finding", () => {
    const r = ran(file("main.h", turned(["CALL PGM main"])));
    expect([r.status, r.codes]).toEqual([1, expect.arrayContaining(["programsTooDeep"])]);
  });
});

describe("--skip leaves out the blocks behind a skip mark", () => {
  const lines = ["/ L X+71.3 FMAX", "L Z+12.9 FMAX", "CALL PGM SUB"];
  const sub = "0 BEGIN PGM SUB MM\n/1 L X+66.1 FMAX\n2 /L IZ-1 FMAX\n3 L IZ-2.5 FMAX\n4 END PGM SUB MM\n";
  test("in the program and in those that it calls", () => {
    file("SUB.H", sub);
    const path = file("main.h", turned(lines));
    expect(ran(path).places).toEqual(["71.3 40.7", "71.3 12.9", "66.1 12.9", "66.1 11.9", "66.1 9.4"]);
    expect(ran(path, "--skip").places).toEqual(["91.3 12.9", "91.3 10.4"]);
    expect(ran("--skip", path).places).toHaveLength(2);
  });
  test("errors of such a block do not count, and the bytes stay", () => {
    const text = turned(["/CALL LBL 77", "/ L X+Q9 FMAX"]);
    const path = file("main.h", text);
    expect(ran(path).codes).toEqual(["labelMissing", "parameterUnset"]);
    expect(ran(path, "--skip")).toMatchObject({ status: 0, codes: [] });
    out = "";
    expect(main([path, "--skip", "--print"])).toBe(0);
    expect(out).toBe(text);
  });
});
