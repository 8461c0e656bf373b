import { spawnSync } from "node:child_process";
import { chmodSync, copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { afterAll, beforeAll, describe, expect, test, vi } from "vitest";
import { bundle } from "../scripts/bundle.mjs";
import { main } from "../scripts/verify.ts";

/** A folder with the built verify.mjs, programs and tools: no checkout and no packages. */
let folder = "";

const GROOVE = "tests/programs/groove-852.h";
/** A program that calls its cycle without turning mode, and ends in the middle of a block. */
const broken = () =>
  readFileSync("tests/programs/shoulder-812.h", "utf8").replace("FUNCTION MODE TURN", "").slice(0, -9);

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), "standalone-"));
  const path = join(folder, "verify.mjs");
  writeFileSync(path, `#!/usr/bin/env node\n${await bundle("standalone", { minify: true })}`);
  chmodSync(path, 0o755);
  for (const name of ["shoulder-812", "groove-852"])
    copyFileSync(`tests/programs/${name}.h`, join(folder, `${name}.h`));
  writeFileSync(join(folder, "broken.h"), broken());
  writeFileSync(
    join(folder, "tools.json"),
    JSON.stringify({
      tools: [{ T: 1, NAME: "OURS", TYPE: "ROUGH", TO: 1, RS: 0.37, "T-ANGLE": 95, "P-ANGLE": 80, CUTLENGTH: 11.3 }],
    }),
  );
});
afterAll(() => rmSync(folder, { recursive: true }));

/** Runs the file itself, by its shebang line, without access to this project. */
function alone(args: readonly string[], { input = "", cwd = folder } = {}) {
  const { status, stdout, stderr } = spawnSync(join(folder, "verify.mjs"), args, { cwd, input, encoding: "utf8" });
  return { status, out: stdout, err: stderr };
}
/** Runs the command of the checkout. */
function checkout(args: readonly string[]) {
  let [out, err] = ["", ""];
  const spies = [
    vi.spyOn(process.stdout, "write").mockImplementation((data) => Boolean((out += String(data)))),
    vi.spyOn(process.stderr, "write").mockImplementation((data) => Boolean((err += String(data)))),
  ];
  const here = process.cwd();
  process.chdir(folder);
  try {
    return { status: main(args), out, err };
  } finally {
    process.chdir(here);
    for (const spy of spies) spy.mockRestore();
  }
}
/** Only the durations may differ. */
const timeless = (ran: ReturnType<typeof alone>) => ({
  ...ran,
  out: ran.out.replaceAll(/"milliseconds":\{[^}]*\}/g, ""),
});

describe("verify.mjs", () => {
  test.each([
    ["many programs with the shop's tools", ["shoulder-812.h", "groove-852.h", "--tools", "tools.json", "--json"], 0],
    ["in words", ["shoulder-812.h", "--control", "TNC7"], 0],
    ["a broken program", ["broken.h", "shoulder-812.h", "--json"], 1],
    ["the text of a program", ["broken.h", "--print"], 0],
    ["no such file", ["shoulder-812.h", "none.h"], 2],
    ["a broken tools file", ["shoulder-812.h", "--tools", "broken.h"], 2],
    ["an option that there is not", ["--frob"], 2],
    ["the version", ["--version"], 0],
  ])("says what the checkout says: %s", (_, args, status) => {
    const [here, there] = [timeless(alone(args)), timeless(checkout(args))];
    expect(there.status).toBe(status);
    expect(here).toEqual(there);
    expect(here.out + here.err).not.toBe("");
  });
  test("runs with the shop's tools, and not with its own of that number", () => {
    const tool = (args: string[]) =>
      (JSON.parse(alone(["shoulder-812.h", "--json", ...args]).out) as { operations: { tool: object }[] }).operations[0]
        ?.tool;
    expect(tool(["--tools", "tools.json"])).toMatchObject({ NAME: "OURS", RS: 0.37 });
    expect(tool([])).toMatchObject({ NAME: "CNMG-80-R08" });
  });
  test("reads a program from standard input, with what it calls from the folder", () => {
    writeFileSync(
      join(folder, "SUB.H"),
      "0 BEGIN PGM SUB MM\n1 L X+77.3 Z+3.1 R0 FMAX\n2 L X+71.9 FMAX\n3 END PGM SUB MM\n",
    );
    const input = [
      "BEGIN PGM MAIN MM",
      "BLK FORM CYLINDER Z D80 L100 DIST+1",
      "TOOL CALL 1",
      "FUNCTION MODE TURN",
      "CALL PGM SUB.H",
      "M30",
      "END PGM MAIN MM",
    ]
      .map((line, i) => `${i} ${line}\n`)
      .join("");
    const { status, out } = alone(["-", "--json"], { input });
    expect(JSON.parse(out)).toMatchObject({ file: "-", program: { name: "MAIN" }, moves: [{ x: 71.9, z: 3.1 }] });
    expect(status).toBe(0);
    expect(alone(["-", "-"], { input })).toMatchObject({ status: 2, out: "", err: "verify: - can be read once\n" });
  });
  test("uses the name by which it was called", () => {
    const { status, out } = alone(["--help"]);
    expect(status).toBe(0);
    expect(out).toMatch(/^usage: node verify\.mjs FILE\.h/);
    for (const option of ["--tools", "--control", "--skip", "--json", "--print", "--help"])
      expect(out).toContain(`  ${option}`);
    expect(alone([])).toMatchObject({
      status: 2,
      out: "",
      err: expect.stringMatching(/^verify: usage: node verify\.mjs .*\n$/),
    });
  });
  test("can be called from another folder", () => {
    const other = join(folder, "other");
    mkdirSync(other);
    const { status, out } = alone([resolve(GROOVE), "--json"], { cwd: other });
    expect(status).toBe(0);
    expect(JSON.parse(out)).toMatchObject({ format: "turnwise-report/1", operations: [{ cycle: 852 }] });
  });
});
