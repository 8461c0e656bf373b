import { describe, expect, test } from "vitest";
import { parse } from "../nc/parse.ts";
import { print } from "../nc/program.ts";
import { run } from "./run.ts";
import { shippedTools } from "./shipped-tools.ts";

const made = (text: string) => {
  const program = parse(text);
  expect(print(program)).toBe(text);
  return run(program, { tools: shippedTools, rapid: 10_000 });
};
const milled = (lines: string, unit = "MM") =>
  made(`BEGIN PGM F ${unit}\nTOOL CALL 77 Z S900 F300\nFUNCTION MODE MILL\nL X-3 Y-7 Z+2 R0 FMAX\n${lines}\nM30\nEND PGM F ${unit}\n`);
const round = (n: number) => Math.round(n * 1000) / 1000 + 0;
const places = (lines: string, unit?: string) =>
  milled(lines, unit).plane.slice(1).map((m) => `${m.kind} ${round(m.to.x)} ${round(m.to.y)}`);
const codes = (lines: string) => milled(lines).issues.filter((f) => f.issue.severity !== "info").map((f) => f.issue.code);

describe("free contours of a mill", () => {
  test("a line by its angle and length, one by its angle and an end", () =>
    expect(places("FL AN+90 LEN12.5 F500\nFL X+10 AN+0")).toEqual(["feed -3 5.5", "feed 10 5.5"]));
  test("two lines whose corner follows from what stands behind it", () =>
    expect(places("FL AN+45\nFL X+17 Y+3 AN+0")).toEqual(["feed 7 3", "feed 17 3"]));
  test("a tangential arc between two lines, with comments between", () =>
    expect(places("L Y+0\n; up\nFCT DR- R4 X+1 Y+4\nFLT X+20\nL X+25")).toEqual(["feed -3 0", "arc 1 4", "feed 20 4", "feed 25 4"]));
  test("an arc round its centre, and one of more than half a turn", () => {
    expect(places("FC DR+ CCX-3 CCY+1 X-3 Y+9")).toEqual(["arc -3 9"]);
    const [arc] = milled("FC DR+ CCX-3 CCY+1 X-11 Y+1").plane.slice(1);
    expect(arc?.centre && { x: round(arc.centre.x), y: round(arc.centre.y) }).toEqual({ x: -3, y: 1 });
  });
  test("FPOL and polar ends, FSELECT, parameters, datum and inches", () => {
    expect(places("FPOL X+2 Y-7\nFL PR+8 PA+90")).toEqual(["feed 2 1"]);
    expect(places("Q7 = 30\nFL AN+Q7 LEN10")).toEqual([`feed ${round(-3 + 5 * Math.sqrt(3))} -2`]);
    expect(places("TRANS DATUM AXIS X+100\nFL X+5 Y-7")).toEqual(["feed 105 -7"]);
    expect(places("FL AN+0 LEN1", "INCH")).toEqual(["feed -50.8 -177.8"]);
  });
  test("an incremental end counts from the element before", () => expect(places("FL IX+4 IY-2")).toEqual(["feed 1 -9"]));
  test("what is not determined, contradicts or is not understood is unproved, with a reason", () => {
    for (const lines of ["FL X+10 AN+90 LEN3", "FL AN+30", "FL P1X+5 P1Y+6 AN+10 X+7", "FC R5", "FL X+10 AN+Q99", "FLT X+10"])
      expect(codes(lines).filter((c) => c === "notProved" || c === "freeUnsolved").sort(), lines).toEqual(
        expect.arrayContaining(["freeUnsolved", "notProved"]),
      );
    expect(codes("FL X+10 Y+3")).toEqual([]);
    expect(milled("FL AN+30\nL X+5 Y+5\nL X+9").plane.at(-1)).toMatchObject({ from: { x: 5 }, to: { x: 9 } });
  });
});

describe("free contours of a turning tool", () => {
  const head =
    "BEGIN PGM F MM\nBLK FORM CYLINDER Z D80 L100 DIST+1\nFUNCTION MODE TURN\nTOOL CALL 1\nFUNCTION TURNDATA SPIN VCONST:OFF S500\n"
    + "M136\nL X+90 Z+5 R0 FMAX\n";
  test("diameters in X, angles to +Z", () => {
    const done = made(`${head}L X+40 Z+0 F0.2\nFL Z-10 AN+180\nFL X+60 AN+135\nM30\nEND PGM F MM\n`);
    expect(done.steps.slice(-2).map((s) => [round(s.move.to.r), round(s.move.to.z)])).toEqual([[20, -10], [30, -20]]);
    expect(done.unproved).toEqual([]);
  });
  test("a contour in a label", () => {
    const outline = (lines: string) =>
      made(`${head.replace(/BLK.*\n/, "BLK FORM ROTATION Z DIM_D LBL 5\n")}M30\nLBL 5\n${lines}\nLBL 0\nEND PGM F MM\n`);
    const rings = (lines: string) => outline(lines).blank.flat().map((p) => [round(p.z), round(p.r)]);
    expect(rings("L X+40 Z+0\nFL Z-10 AN+180\nFL X+60 AN+135\nL Z-50")).toEqual(rings("L X+40 Z+0\nL Z-10\nL X+60 Z-20\nL Z-50"));
    expect(rings("L X+40 Z+0\nL Z-10\nFCT DR- R5 X+50 Z-15\nL Z-50")).toEqual(rings("L X+40 Z+0\nL Z-10\nCT X+50 Z-15\nL Z-50"));
    expect(outline("L X+40 Z+0\nFL AN+180\nL Z-50").issues.map((f) => f.issue.code)).toContain("freeUnsolved");
  });
});
