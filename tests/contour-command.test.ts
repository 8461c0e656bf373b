import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { main } from "../scripts/contour.ts";
import { parse } from "../src/nc/parse.ts";
import { asText, dxfGroups, line, polyline, utf8, type Entity } from "./drawings/dxf-file.ts";

let [folder, out, err] = ["", "", ""];
beforeEach(() => {
  [folder, out, err] = [mkdtempSync(join(tmpdir(), "contour-")), "", ""];
  vi.spyOn(process.stdout, "write").mockImplementation((data) => Boolean((out += String(data))));
  vi.spyOn(process.stderr, "write").mockImplementation((data) => Boolean((err += String(data))));
});
afterEach(() => {
  vi.restoreAllMocks();
  rmSync(folder, { recursive: true });
});

const file = (bytes: Uint8Array, name = "part.dxf") => {
  const path = join(folder, name);
  writeFileSync(path, bytes);
  return path;
};
const drawn = (entities: readonly Entity[], units = 4) =>
  file(utf8(asText(dxfGroups({ header: [["$INSUNITS", 70, units]], entities }))));
const QUARTER = Math.tan(Math.PI / 8);
const shaft = () =>
  drawn([
    polyline(false, [
      [0, 12],
      [-18, 12, -QUARTER],
      [-22, 16],
      [-22, 27],
      [-46, 27],
    ]),
    "SOLID 8 0 10 0 20 0",
  ]);
const bush = () =>
  drawn(
    [
      polyline(true, [
        [0, 1.5],
        [0, 2],
        [-3, 2],
        [-3, 1.5],
      ]),
      line(-1, 0.5, 0, 0.5, "8 AUX"),
    ],
    1,
  );

test("the contour is a subprogram on standard output, what was not used is on standard error", async () => {
  expect(await main([shaft()])).toBe(0);
  expect(out).toBe("LBL 1\nL X+24 Z+0\nL Z-18\nCR X+32 Z-22 R+4 DR-\nL X+54\nL Z-46\nLBL 0\n");
  expect(err).toBe("info: Not used: 1 × SOLID.\n");
  expect(parse(out).blocks.flatMap((b) => b.issues ?? [])).toEqual([]);
});

test.each([
  [["--side", "bore"], "L X+76.2 Z+0\nL Z-76.2"],
  [["--zero", "-3"], "L X+76.2 Z+76.2\nL X+101.6\nL Z+0"],
  [["--axis", "0.5"], "L X+50.8 Z+0\nL X+76.2\nL Z-76.2"],
  [["--axis", "y=1", "--side", "bore", "--reversed"], "L X+25.4 Z-76.2\nL Z+0"],
  [["--axis", "X=-3"], "L X+0 Z+0\nL X+152.4\nL Z-12.7"],
  [["--unit", "mm", "--gap", "0.5", "--layer", "0"], "L X+3 Z+0\nL X+4\nL Z-3"],
  [["--half", "lower", "--axis", "2"], "L X+0 Z+0\nL X+25.4\nL Z-76.2"],
  [["--piece", "2"], "L X+25.4 Z+0\nL Z-25.4"],
  [["--mirrored"], "L X+76.2 Z+0\nL X+101.6\nL Z-76.2"],
  [["--diameters"], "L X+38.1 Z+0\nL X+50.8\nL Z-76.2"],
] as const)("%j in the unit of the drawing", async (options, contour) => {
  expect(await main([bush(), ...options])).toBe(0);
  expect(out).toBe(`LBL 1\n${contour}\nLBL 0\n`);
});

test.each([
  [() => file(utf8("hello")), "error: This file is not a readable DXF drawing.\n"],
  [() => file(utf8("%PDF"), "part.pdf"), "error: This is not a drawing that can be read. Kinds that can: DXF"],
  [() => drawn(["TEXT 8 0 10 0 20 0 1 x"]), "error: The drawing contains no lines, arcs or curves.\n"],
])("without a contour the status is 1 and the reason is said", async (path, reason) => {
  expect(await main([path()])).toBe(1);
  expect([out, err.slice(0, reason.length)]).toEqual(["", reason]);
});

test.each([
  [[], "usage: "],
  [["a.dxf", "b.dxf"], "one drawing at a time"],
  [["--foo"], "unknown option --foo"],
  [["--unit"], "--unit needs a value"],
  [["--unit", "cm"], "--unit needs one of mm, inch, not cm"],
  [["--axis", "up"], "--axis needs a number, not up"],
  [["--zero", "x"], "--zero needs a number, not x"],
  [["--half", "left"], "--half needs one of upper, lower"],
  [["--piece", "0"], "--piece needs a number from 1, not 0"],
  [["--gap", "-1"], "--gap needs a width of 0 or more"],
  [["nowhere.dxf"], "cannot read nowhere.dxf"],
])("wrong use %j is named with status 2", async (args, reason) => {
  expect(await main(args)).toBe(2);
  expect(out).toBe("");
  expect(err).toMatch(new RegExp(`^contour: ${reason}`));
  expect(err.trimEnd().split("\n")).toHaveLength(1);
});

test("a piece or a layer that the drawing does not have is wrong use", async () => {
  expect(await main([bush(), "--piece", "3"])).toBe(2);
  expect(await main([bush(), "--layer", "OUTLINE"])).toBe(2);
  expect(err).toBe("contour: --piece 3: there are 2\ncontour: no layer OUTLINE; there are 0, AUX\n");
});

test("help says what the options do", async () => {
  expect(await main(["--help"])).toBe(0);
  for (const option of ["--unit", "--axis", "--zero", "--half", "--piece", "--side", "--gap", "--layer", "--thin"])
    expect(out).toContain(option);
});
