import { describe, expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const made = (text: string) => {
  const program = parse(text);
  expect(print(program)).toBe(text);
  return run(program, { tools: shippedTools, rapid: 10_000 });
};
const milled = (lines: string, unit = "MM") =>
  made(
    `BEGIN PGM F ${unit}\nTOOL CALL 77 Z S900 F300\nFUNCTION MODE MILL\nL X-3 Y-7 Z+2 R0 FMAX\n${lines}\nM30\nEND PGM F ${unit}\n`,
  );
const round = (n: number) => Math.round(n * 1000) / 1000 + 0;
const places = (lines: string, unit?: string) =>
  milled(lines, unit)
    .plane.slice(1)
    .map((m) => `${m.kind} ${round(m.to.x)} ${round(m.to.y)}`);
const codes = (lines: string) =>
  milled(lines)
    .issues.filter((f) => f.issue.severity !== "info")
    .map((f) => f.issue.code);

describe("free contours of a mill", () => {
  test("a line by its angle and length, one by its angle and an end", () =>
    expect(places("FL AN+90 LEN12.5 F500\nFL X+10 AN+0")).toEqual(["feed -3 5.5", "feed 10 5.5"]));
  test("two lines whose corner follows from what stands behind it", () =>
    expect(places("FL AN+45\nFL X+17 Y+3 AN+0")).toEqual(["feed 7 3", "feed 17 3"]));
  test("a tangential arc between two lines, with comments between", () =>
    expect(places("L Y+0\n; up\nFCT DR- R4 X+1 Y+4\nFLT X+20\nL X+25")).toEqual([
      "feed -3 0",
      "arc 1 4",
      "feed 20 4",
      "feed 25 4",
    ]));
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
  test("tangents between circles that are known, a contour that closes", () => {
    const lines =
      "L X+2 Y+30\nFC DR- R18 CLSD+ CCX+20 CCY+30\nFLT\nFCT DR- R15 CCX+50 CCY+75\nFLT\nFCT DR+ R10 CCX+75 CCY+20\nFLT\n" +
      "FCT DR- R18 CLSD- CCX+20 CCY+30\nL X+2 Y+31";
    const done = milled(lines);
    expect(done.issues.filter((f) => f.issue.code === "freeUnsolved")).toEqual([]);
    const ends = done.plane.slice(2).map((m) => [m.to.x, m.to.y] as const);
    const circles = [
      [20, 30, 18],
      [50, 75, 15],
      [75, 20, 10],
      [20, 30, 18],
    ] as const;
    // Every line touches the circle that it leaves and the one that it comes to, and runs square to both radii.
    for (const k of [0, 1, 2]) {
      const [a, b] = [ends[2 * k], ends[2 * k + 1]];
      for (const [p, circle] of [
        [a, circles[k]],
        [b, circles[k + 1]],
      ] as const) {
        const [x, y] = [(p?.[0] ?? NaN) - (circle?.[0] ?? NaN), (p?.[1] ?? NaN) - (circle?.[1] ?? NaN)];
        expect(Math.hypot(x, y)).toBeCloseTo(circle?.[2] ?? NaN, 6);
        expect(x * ((b?.[0] ?? NaN) - (a?.[0] ?? NaN)) + y * ((b?.[1] ?? NaN) - (a?.[1] ?? NaN))).toBeCloseTo(0, 6);
      }
    }
    expect(ends[0]?.map(round)).toEqual([5.6, 40.8]);
    expect(ends[6]?.map(round)).toEqual([2, 30]);
  });
  test("circles that lie in each other have no tangent, and a radius that is not that of its centre is no circle", () => {
    expect(codes("L X+2 Y+30\nFC DR- R18 CCX+20 CCY+30\nFLT\nFCT DR- R5 CCX+22 CCY+30\nFLT X+90")).toContain(
      "freeUnsolved",
    );
    expect(codes("L X+2 Y+30\nFC DR- R17 CCX+20 CCY+30 X+20 Y+48")).toContain("freeUnsolved");
    expect(codes("L X+2 Y+30\nFC DR- R18 CCX+20 CCY+30 X+20 Y+47")).toContain("freeUnsolved");
    expect(codes("L X+2 Y+30\nFC DR- R18 CCX+20 CCY+30 X+20 Y+48")).toEqual([]);
  });
  test("a centre by FPOL, which counts until the next one", () => {
    expect(places("FPOL X-3 Y-27\nL X-3 Y-7\nFC DR- CCPR+10 CCPA+90 X+7 Y-17").at(-1)).toBe("arc 7 -17");
    expect(places("FPOL X+2 Y-7\nL Y+0\nCC X+0 Y+0\nFL PR+8 PA+90").at(-1)).toBe("feed 2 1");
    expect(codes("FC DR- CCPR+10 CCPA+90 X+7 Y-17")).toContain("freeUnsolved");
  });
  test("an approach to an element that nobody could work out is unproved, and no fault", () => {
    const done = milled(
      "TOOL DEF 5 L+0 R+2\nTOOL CALL 5 Z S900\nL X-30 Y-7\nAPPR LT X+0 Y+0 LEN5 RL F100\nFL PDX+3 D4\nDEP LT LEN9\nL X-30 Y-40 R0",
    );
    expect(done.issues.filter((f) => f.issue.severity === "error")).toEqual([]);
    expect(done.unproved.map((u) => u.what)).toEqual(expect.arrayContaining(["APPR LT", "FL", "DEP LT"]));
  });
  test("lines between circles, closed where they began", () => {
    const lines =
      "L X+2 Y+30\nFC DR- R17.5 CLSD+ CCX+19.5 CCY+30\nFLT\nFCT DR- R14 CCX+52 CCY+73\nFLT\nFCT DR- R17.5 CLSD- CCX+19.5 CCY+30";
    expect(codes(lines)).toEqual([]);
    const { plane } = milled(lines);
    expect(plane.at(-1)?.to).toMatchObject({ x: expect.closeTo(2, 6) as number, y: expect.closeTo(30, 6) as number });
    expect(plane.slice(-5).map((m) => m.kind)).toEqual(["arc", "feed", "arc", "feed", "arc"]);
  });
  test("angles, ends and centres that count from other blocks, by their numbers", () => {
    const numbered = milled(
      "12 FL AN+15 LEN20 F300\n13 FL AN+105 LEN12.5\n14 FL PAR12 DP12.5 AN+195 LEN5\n15 FL IAN+90 LEN3\n16 FL IAN+45 RAN13 LEN2\n" +
        "17 FL IX+7 RX12 IY+1 RY13",
    );
    const way = numbered.plane.slice(1).map((m) => [m.to.x - m.from.x, m.to.y - m.from.y].map((n) => n ?? 0));
    expect(way.map(([x = 0, y = 0]) => Math.round((Math.atan2(y, x) * 180) / Math.PI + 360) % 360).slice(0, 5)).toEqual(
      [15, 105, 195, 285, 150],
    );
    const [first, second] = numbered.plane.slice(1);
    expect(round((numbered.plane.at(-1)?.to.x ?? 0) - (first?.to.x ?? 0))).toBe(7);
    expect(round((numbered.plane.at(-1)?.to.y ?? 0) - (second?.to.y ?? 0))).toBe(1);
    expect(places("5 FL X+10 Y+0\n6 FC DR- ICCX+0 ICCY-8 RCCX5 RCCY5 CCA90")).toEqual(["feed 10 0", "arc 18 -8"]);
  });
  test("points that an element runs through or past, and a centre from the pole", () => {
    expect(places("FL P1X+0 P1Y-7 X+12 Y-7")).toEqual(["feed 12 -7"]);
    expect(places("FL AN+90 Y+1\nFL AN+0 PDX+50 PDY+4 D3 X+20", "MM").at(-1)).toBe("feed 20 1");
    expect(places("FPOL X-3 Y+13\nFC DR+ CCPR+10 CCPA-90 R10 X+7 Y+3")).toEqual(["arc 7 3"]);
  });
  test("where another contour fits as well, the shortest runs and is unproved, once", () => {
    expect(
      codes("FC DR+ R10 CCX+7 CCY-7 X+1 F200\nFSELECT2\nFL X+30 Y+0").filter((c) => c !== "notInTurnMode"),
    ).toEqual(expect.arrayContaining(["freeChosen", "notProved"]));
    expect(
      codes("FC DR+ R10 CCX+7 CCY-7 X+1 F200\nFL AN+0 LEN4\nFL X+30 Y+0").filter((c) => c === "freeChosen"),
    ).toHaveLength(1);
  });
  test("an incremental end counts from the element before", () =>
    expect(places("FL IX+4 IY-2")).toEqual(["feed 1 -9"]));
  test("what is not determined, contradicts or is not understood is unproved, with a reason", () => {
    for (const lines of [
      "FL X+10 AN+90 LEN3",
      "FL AN+30",
      "FL P1X+5 P1Y+6 AN+10 X+7",
      "FL PAR99 DP3 X+2",
      "FL PDX+3 PDY+4 X+9 Y+1",
      "FC R5",
      "FL X+10 AN+Q99",
      "FLT X+10",
    ])
      expect(
        codes(lines)
          .filter((c) => c === "notProved" || c === "freeUnsolved")
          .sort(),
        lines,
      ).toEqual(expect.arrayContaining(["freeUnsolved", "notProved"]));
    expect(codes("FL X+10 Y+3")).toEqual([]);
    expect(milled("FL AN+30\nL X+5 Y+5\nL X+9").plane.at(-1)).toMatchObject({ from: { x: 5 }, to: { x: 9 } });
  });
});

describe("free contours of a turning tool", () => {
  const head =
    "BEGIN PGM F MM\nBLK FORM CYLINDER Z D80 L100 DIST+1\nFUNCTION MODE TURN\nTOOL CALL 1\nFUNCTION TURNDATA SPIN VCONST:OFF S500\n" +
    "M136\nL X+90 Z+5 R0 FMAX\n";
  test("diameters in X, angles to +Z", () => {
    const done = made(`${head}L X+40 Z+0 F0.2\nFL Z-10 AN+180\nFL X+60 AN+135\nM30\nEND PGM F MM\n`);
    expect(done.steps.slice(-2).map((s) => [round(s.move.to.r), round(s.move.to.z)])).toEqual([
      [20, -10],
      [30, -20],
    ]);
    expect(done.unproved).toEqual([]);
  });
  test("a contour in a label", () => {
    const outline = (lines: string) =>
      made(
        `${head.replace(/BLK.*\n/, "BLK FORM ROTATION Z DIM_D LBL 5\n")}M30\nLBL 5\n${lines}\nLBL 0\nEND PGM F MM\n`,
      );
    const rings = (lines: string) =>
      outline(lines)
        .blank.flat()
        .map((p) => [round(p.z), round(p.r)]);
    expect(rings("L X+40 Z+0\nFL Z-10 AN+180\nFL X+60 AN+135\nL Z-50")).toEqual(
      rings("L X+40 Z+0\nL Z-10\nL X+60 Z-20\nL Z-50"),
    );
    expect(rings("L X+40 Z+0\nL Z-10\nFCT DR- R5 X+50 Z-15\nL Z-50")).toEqual(
      rings("L X+40 Z+0\nL Z-10\nCT X+50 Z-15\nL Z-50"),
    );
    expect(outline("L X+40 Z+0\nFL AN+180\nL Z-50").issues.map((f) => f.issue.code)).toContain("freeUnsolved");
  });
});
