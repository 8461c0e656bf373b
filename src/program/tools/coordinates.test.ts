import { describe, expect, test } from "vitest";
import { toDiameter } from "../../kernel/units.ts";
import { parse } from "../../nc/parse.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "./shipped-tools.ts";

const SHOULDER =
  "CYCL DEF 812 NAME ~\n" +
  "Q215=+0 Q460=+2 Q491=+75 Q492=+0 Q493=+50 Q494=-55 Q495=+5 Q501=+1 Q502=+0.5 Q500=+1.5 Q496=+0 Q503=+1 Q504=+0.5 Q463=+3 " +
  "Q478=+0.3 Q483=+0.4 Q484=+0.2 Q505=+0.2 Q506=+0".split(" ").join(" ~\n");
const turned = (lines: string, unit = "MM") =>
  run(
    parse(
      `0 BEGIN PGM T ${unit}\n1 BLK FORM CYLINDER Z D80 L100 DIST+1 DI20\n2 FUNCTION MODE TURN\n3 TOOL CALL 1\n4 FUNCTION ` +
        `TURNDATA SPIN VCONST:OFF S500\n5 M136\n6 L X+100 Z+50 R0 FMAX\n${lines}\nM30\nEND PGM T ${unit}\n`,
    ),
    { tools: shippedTools, rapid: 10_000 },
  );
const milled = (lines: string, unit = "MM") =>
  run(
    parse(`0 BEGIN PGM M ${unit}\n1 TOOL CALL 1 Z S1000\n2 L X+0 Y+0 Z+10 R0 FMAX\n${lines}\nM30\nEND PGM M ${unit}\n`),
    {
      tools: shippedTools,
      rapid: 10_000,
    },
  );
type Made = ReturnType<typeof run>;
const round = (n: number) => +n.toFixed(3) + 0;
const path = (r: Made) =>
  r.steps
    .filter((s) => s.operation === null)
    .map((s) => `${s.move.kind} ${round(toDiameter(s.move.to.r))} ${round(s.move.to.z)}`);
const plane = (r: Made) =>
  r.plane.map(
    (s) =>
      `${s.kind} ${round(s.to.x)} ${round(s.to.y)} ${s.to.z === null ? "?" : round(s.to.z)}${s.feed === undefined ? "" : ` F${s.feed}`}`,
  );
const unproved = (r: Made) => r.unproved.map((u) => `${u.what}@${u.block}`);
const codes = (r: Made) => r.issues.filter((f) => f.issue.severity !== "info").map((f) => `${f.issue.code}@${f.block}`);

describe("the datum is shifted", () => {
  test("by cycle 7 and by TRANS DATUM, X as a diameter, each axis on its own", () => {
    expect(path(turned("CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 Z-30\nL X+80 Z+2 FMAX"))).toEqual(["rapid 80 -28"]);
    expect(
      path(
        turned(
          "CYCL DEF 7.0 NULLPUNKT\nCYCL DEF 7.1 X+4\nCYCL DEF 7.2 IZ-10\nCYCL DEF 7.3 IZ-5.5\nL X+80 Z+2 FMAX\nL IX-2 FMAX",
        ),
      ),
    ).toEqual(["rapid 84 -13.5", "rapid 82 -13.5"]);
    expect(
      path(
        turned(
          "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 Z-20\nTRANS DATUM AXIS X+1 Z-40\nL X+80 Z+45 FMAX\nTRANS DATUM RESET\nL Z+2 FMAX",
        ),
      ),
    ).toEqual(["rapid 81 5", "rapid 81 2"]);
    expect(path(turned("Q5 = -7\nTRANS DATUM AXIS Z+Q5\nL Z+0 FMAX"))).toEqual(["rapid 100 -7"]);
    expect(unproved(turned("CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 Z-30\nTRANS DATUM RESET"))).toEqual([]);
  });
  test("in inches, and while milling", () => {
    expect(path(turned("TRANS DATUM AXIS Z-1\nL X+3 Z+0.5 FMAX", "INCH"))).toEqual(["rapid 76.2 -12.7"]);
    expect(plane(milled("TRANS DATUM AXIS X+10 Y-5 Z+1\nL X+1 Y+1 Z+1 FMAX\nCC X+5 Y+1\nC X+9 Y+1 DR+ F100"))).toEqual([
      "rapid 0 0 10",
      "rapid 11 -4 2",
      "arc 19 -4 2 F100",
    ]);
  });
  test("a cycle stands where the shift puts it, with path, part and contour", () => {
    const plain = turned(`${SHOULDER}\nL X+75 Z+2 FMAX\nCYCL CALL`).operations[0];
    const shifted = turned(`TRANS DATUM AXIS Z-12.345 X+0\n${SHOULDER}\nL X+75 Z+2 FMAX\nCYCL CALL`).operations[0];
    const z = (points: readonly { readonly z: number }[] | undefined) => points?.map((p) => round(p.z));
    const away = (points: number[] | undefined) => points?.map((n) => round(n - 12.345));
    expect(round(shifted?.start.z ?? 0)).toBe(-10.345);
    expect(shifted?.call?.start).toEqual(plain?.start);
    expect(z(shifted?.plan.contour.map((s) => s.to))).toEqual(away(z(plain?.plan.contour.map((s) => s.to))));
    expect(z(shifted?.plan.part)).toEqual(away(z(plain?.plan.part)));
    expect(shifted?.plan.reach.length).toBe(plain?.plan.reach.length);
    expect(shifted?.plan.moves.map((m) => m.to.r)).toContain(plain?.plan.moves[2]?.to.r);
  });
  test.each([
    ["CYCL DEF 8.0 MIRROR\nCYCL DEF 8.1 X", ["CYCL DEF 8@8"]],
    ["CYCL DEF 8.0 MIRROR\nCYCL DEF 8.1", []],
    ["CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+35", ["CYCL DEF 10@8"]],
    ["CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+0", []],
    ["CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL 0.99", ["CYCL DEF 11@8"]],
    ["CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL1", []],
    ["CYCL DEF 26.0 AXIS SCALING\nCYCL DEF 26.1 X1.4 Y1 CCX+15 CCY+20", ["CYCL DEF 26@8"]],
    ["CYCL DEF 26.0 AXIS SCALING\nCYCL DEF 26.1 X1 Y1 CCX+15", []],
    ["CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A+0 B+45 C+0", ["CYCL DEF 19@8"]],
    ["CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A+0 B+0 C+0", []],
    ["CYCL DEF 7.0 DATUM\nCYCL DEF 7.1 #5", ["CYCL DEF 7 #5@8"]],
    ["CYCL DEF 12.0 PGM CALL\nCYCL DEF 12.1 SUB.H", []],
    ["CYCL DEF 12.0 PGM CALL\nCYCL DEF 12.1 SUB.H\nCYCL CALL", ["CYCL DEF 12@9"]],
    ["TRANS MIRROR AXIS X", ["TRANS MIRROR@7"]],
    ["TRANS MIRROR RESET", []],
    ["TRANS ROTATION ROT+12.5", ["TRANS ROTATION@7"]],
    ["TRANS ROTATION ROT+0", []],
    ["TRANS SCALE SCL0.5", ["TRANS SCALE@7"]],
    ["TRANS SCALE SCL1", []],
    ["TRANS SCALE RESET", []],
    ["TRANS ROTATION IROT+5\nTRANS ROTATION IROT-5", ["TRANS ROTATION@7"]],
    ["TRANS ROTATION RESET", []],
    ["TRANS DATUM TABLE TABLINE5", ["TRANS DATUM TABLE TABLINE5@7"]],
    ["FUNCTION RESET TCPM", []],
    ["CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.05", []],
    ["CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 2", []],
    ["CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+0\nCYCL DEF 7.2 Z+0", []],
    ["CYCL DEF 247 PRESET ~\nQ339=+1\nCYCL DEF 247 PRESET ~\nQ339=+1", []],
    ["CYCL DEF 392 BUILDER ~\nQ240=+1", []],
    ["PLANE SPATIAL SPA+0 SPB+20 SPC+0 MOVE DIST50 F1000", ["PLANE SPATIAL@7"]],
    ["PLANE SPATIAL SPA+0 SPB+0 SPC+0 MOVE DIST50 F1000", []],
    ["PLANE RESET STAY", []],
    ["CYCL DEF 247 PRESET ~\nQ339=+1", []],
    ["CYCL DEF 247 PRESET ~\nQ339=+1\nCYCL DEF 247 PRESET ~\nQ339=+2", ["CYCL DEF 247@8"]],
    ["CYCL DEF 800 ADAPT ~\nQ497=+0 ~\nQ498=+0 ~\nQ531=+0 ~\nQ535=+3", []],
    ["CYCL DEF 800 ADAPT ~\nQ497=+0 ~\nQ498=+1 ~\nQ531=+0", ["CYCL DEF 800@7"]],
    ["CYCL DEF 800 ADAPT ~\nQ497=+0 ~\nQ535=+1", ["CYCL DEF 800@7"]],
    ["CYCL DEF 800 ADAPT ~\nQ497=+0 ~\nQ532=FMAX ~\nQ599=-1", []],
    ["CYCL DEF 800 ADAPT ~\nQ530=+3 ~\nQ531=+0", []],
    ["CYCL DEF 800 ADAPT ~\nQ530=+3 ~\nQ531=+17.5", ["CYCL DEF 800@7"]],
    ["CYCL DEF 801 RESET", []],
    ["CYCL DEF 892 CHECK UNBALANCE ~\nQ450=+0.1\nCYCL CALL", ["CYCL DEF 892 CHECK UNBALANCE@8"]],
  ])("%s: %j", (lines, expected) => expect(unproved(turned(lines))).toEqual(expected));
});

test("an invalid value of a cycle that acts at its definition is reported at its line; no call is missing", () => {
  const done = turned("CYCL DEF 800 ADAPT ~\nQ497=+400 ~\nQ530=+4 ~\nQ531=+0");
  const told = done.issues.map((f) => `${f.issue.code} ${"at" in f.issue ? f.issue.at : ""}@${f.line}`);
  expect(told.filter((t) => t.includes("Q"))).toEqual(["outOfRange Q497@9", "notAChoice Q530@10"]);
  expect(done.issues.map((f) => f.issue.code)).not.toContain("cycleNeverCalled");
});

describe("unknown positions are not invented", () => {
  test("M91 and M92: no steps until both axes are programmed again", () => {
    expect(
      path(turned("L Z-1 R0 FMAX M91\nL X-1 Y-1 R0 FMAX M91\nL X+90 FMAX\nL IZ+3 FMAX\nL Z+5 FMAX\nL Z+4 FMAX")),
    ).toEqual(["rapid 90 4"]);
    expect(unproved(turned("L Z-1 R0 FMAX M92\nL X-1 R0 FMAX M91"))).toEqual(["M92@7"]);
    expect(plane(milled("L Z-1 R0 FMAX M91\nL X+5 FMAX\nL Z+3 FMAX\nL X+6 F100"))).toEqual([
      "rapid 0 0 10",
      "rapid 5 0 ?",
      "feed 6 0 3 F100",
    ]);
    expect(codes(turned(`L Z-1 R0 FMAX M91\n${SHOULDER}\nCYCL CALL`))).toEqual(["startUnknown@9"]);
  });
  test("M140 goes back along the tool axis at its own feed, and MB MAX until the blank is left behind", () => {
    expect(path(turned("L X+30 Z+2 FMAX\nL Z-30 F0.2\nL M140 MB MAX FMAX\nL X+90 FMAX"))).toEqual([
      "rapid 30 2",
      "feed 30 -30",
      "rapid 30 21",
      "rapid 90 21",
    ]);
    expect(path(turned("L X+30 Z+2 FMAX\nL Z-30 F0.2\nL X+32 M140 MB 5.5 F1\nL Z+2"))).toEqual([
      "rapid 30 2",
      "feed 30 -30",
      "feed 30 -24.5",
      "feed 32 -24.5",
      "feed 32 2",
    ]);
    expect(
      plane(milled("L X+5 F125 M140 MB 50 F750\nL X+10\nL X+20 M128 F1000\nL X+30\nL M140 MB MAX\nL X+40")),
    ).toEqual([
      "rapid 0 0 10",
      "feed 0 0 60 F750",
      "feed 5 0 60 F125",
      "feed 10 0 60 F125",
      "feed 20 0 60 F125",
      "feed 30 0 60 F125",
      "feed 40 0 ? F125",
    ]);
  });
  test("a program that begins with an incremental move starts nowhere", () => {
    const begun = run(
      parse("BEGIN PGM I MM\nTOOL CALL 1 Z S1000\nL IX+5 IY+5 IZ+5 FMAX\nL IX+5 F100\nM30\nEND PGM I MM\n"),
      {
        tools: [],
        rapid: 1,
      },
    );
    expect(plane(begun)).toEqual([]);
    expect(path(turned("TOOL CALL 2\nL IZ+5 FMAX\nL IX+5 FMAX\nL X+90 FMAX\nL Z+1 FMAX\nL Z+2 FMAX"))).toEqual([
      // The last position of the previous tool.
      "rapid 100 50",
      "rapid 90 2",
    ]);
  });
  test.each([
    ["CALL PGM TNC:\\SUB.H", ["CALL PGM@7"]],
    ['SEL PGM "SUB.H"', []],
    ['SEL PGM "SUB.H"\nCALL SELECTED PGM', ["CALL SELECTED PGM@8"]],
    ["TCH PROBE 0.0 REF. PLANE Q5 Z-", ["TCH PROBE 0.0@7"]],
    ["FN 18: SYSREAD Q5 = ID270 NR1 IDX3", []],
    ["FN 18: SYSREAD Q5 = ID270 NR1 IDX3\nL Z+Q5 FMAX", ["Q5@8"]],
    ["FN 18: SYSREAD Q5 = ID270 NR1 IDX3\nQ6 = Q5 + 1\nL Z+Q6 FMAX", ["Q6@9"]],
    ["FN 18: SYSREAD Q5 = ID1\nQ5 = 4\nL Z+Q5 FMAX", []],
    ["FN 18: SYSREAD Q5 = ID1\nFN 9: IF +Q5 EQU +1 GOTO LBL 1\nLBL 1", ["Q5@8", "FN 9@8"]],
    ["FN 16: F-PRINT TNC:\\A.A", []],
    ["TCH PROBE 427 MEASURE ~\nQ263=+1\nL Z+Q160 FMAX", ["TCH PROBE 427@7", "Q160@8"]],
    ["FOO BAR", ["FOO BAR@7"]],
    ["L X+90 FMAX FOO9", ["FOO9@7"]],
    ["L X+90 Y+0 FMAX", []],
    ["L X+90 B+30 FMAX", ["B@7"]],
    ["CYCL DEF 200 DRILLING ~\nQ200=+2\nCYCL CALL", ["CYCL DEF 200 DRILLING@8"]],
    ["CYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP 2\nCYCL CALL", ["CYCL DEF 1 PECKING@9"]],
    [`${SHOULDER}\nCYCL CALL PAT FMAX`, ["CYCL CALL PAT@8"]],
  ])("%s leaves unproved %j", (lines, expected) => {
    const made = turned(lines);
    expect(unproved(made)).toEqual(expected);
    expect(made.issues.filter((f) => f.issue.severity === "error")).toEqual([]);
  });
  test("a cycle that would start there is unproved too, and no fault", () => {
    const made = turned(`FN 18: SYSREAD Q5 = ID1\n${SHOULDER}\nL X+75 Z+Q5 FMAX\nCYCL CALL`);
    expect(unproved(made)).toEqual(["Q5@9", "CYCL CALL@10"]);
    expect(codes(made)).toEqual(["notProved@9", "notProved@10"]);
  });
});

describe("the order of the blocks", () => {
  test.each([
    ["FN 9: IF +5 EQU +5 GOTO LBL 1", true],
    ["FN 9: IF +5 EQU +6 GOTO LBL 1", false],
    ["FN 10: IF +Q1 NE +6 GOTO LBL 1", true],
    ["FN 11: IF +Q1 GT +5 GOTO LBL 1", false],
    ['FN 11: IF +Q1 GT +4.9 GOTO LBL "ONE"', true],
    ["FN 12: IF -Q1 LT +Q1 GOTO LBL 1", true],
    ["IF Q1 EQU +5 GOTO LBL 1", true],
    ["FN 9: IF Q1 IS DEFINED GOTO LBL 1", true],
    ["FN 9: IF Q2 IS UNDEFINED GOTO LBL 1", true],
    ["FN 9: IF Q2 IS DEFINED GOTO LBL 1", false],
    ["FN 9: IF +0 EQU +0 GOTO LBL Q9", true],
  ])("%s jumps: %s", (jump, jumps) =>
    expect(path(turned(`Q1 = 5\nQ9 = 1\n${jump}\nL Z+40 FMAX\nLBL 1\nLBL "ONE"\nL X+90 FMAX`)).length).toBe(
      jumps ? 1 : 2,
    ),
  );
  test("a loop of jumps runs, an endless one ends with a message", () => {
    expect(path(turned("Q1 = 0\nLBL 1\nQ1 = Q1 + 1\nL IZ-1 FMAX\nFN 12: IF +Q1 LT +4 GOTO LBL 1"))).toHaveLength(4);
    expect(codes(turned("LBL 1\nFN 9: IF +1 EQU +1 GOTO LBL 1"))).toEqual(["tooManyRepeated@7"]);
    expect(codes(turned("FN 9: IF +1 EQU +1 GOTO LBL 7"))).toEqual(["labelMissing@7"]);
    expect(codes(turned("FN 9: IF +Q1 EQU +1 GOTO LBL 7"))).toEqual(["parameterUnset@7"]);
  });
  test("paraxial blocks run as straight lines", () => {
    expect(path(turned("X+70 R0 FMAX\nZ-20 R0 F0.3\nIX+2\nZ+5 FMAX"))).toEqual([
      "rapid 70 50",
      "feed 70 -20",
      "feed 72 -20",
      "rapid 72 5",
    ]);
    expect(plane(milled("Z+100 FMAX\nX+5 F100"))).toEqual(["rapid 0 0 10", "rapid 0 0 100", "feed 5 0 100 F100"]);
  });
});

describe("arcs run in their plane", () => {
  const arcs = (r: Made) =>
    r.plane
      .filter((s) => s.kind === "arc")
      .map((s) => ({ to: s.to, ...(s.side ? { ...s.side } : { centre: s.centre, turn: s.turn }) }));
  test.each([
    ["L X+12 Z+5 F500\nCC X+10 Z+5\nC X+8 Z+5 DR+", { plane: "ZX", centre: { x: 10, z: 5 }, turn: "ccw" }],
    ["L Y+10 Z+5 F500\nCC Y+12 Z+5\nC Y+14 Z+5 DR-", { plane: "YZ", centre: { y: 12, z: 5 }, turn: "cw" }],
    ["L X+12 Z+5 F500\nCC X+10 Z+5\nCP IPA+90 DR+", { plane: "ZX", to: { x: 10, y: 0, z: 3 }, turn: "ccw" }],
    ["L X+0 Z+5 F500\nCR X+10 Z+15 R+10 DR+", { plane: "ZX", to: { x: 10, y: 0, z: 15 } }],
    ["L Y+0 Z+0 F500\nL Y+10\nCT Y+20 Z+10", { plane: "YZ", centre: { y: 10, z: 10 }, turn: "ccw" }],
    [
      "L X+10 Y+0 Z+5 F500\nCC X+0 Y+0\nCP IPA+90 IZ-2 DR+",
      { to: { x: 0, y: 10, z: 3 }, centre: { x: 0, y: 0 }, turn: "ccw" },
    ],
  ])("%s", (lines, expected) => {
    const made = milled(lines);
    const [arc] = arcs(made);
    expect(JSON.parse(JSON.stringify(arc, (_, v: unknown) => (typeof v === "number" ? round(v) : v)))).toMatchObject(
      expected,
    );
    expect(codes(made)).toEqual([]);
  });
  test("an arc that no plane has is a fault; one under compensation is not proved", () => {
    expect(codes(milled("L X+12 Z+5 F500\nCC X+10 Z+5\nC X+8 Z+9 DR+"))).toEqual(["arcImpossible@5"]);
    expect(unproved(milled("L X+12 Z+5 RL F500\nCC X+10 Z+5\nC X+8 Z+5 DR+"))).toEqual(["C@5"]);
  });
  test("an end that misses the next point by less than a control keeps gives no move of its own", () =>
    expect(
      plane(
        milled(
          "L X61.8098 Y46.2469 F500\nCC X64.5288 Y44.9791\nCP IPA+89.999 IZ0.5 DR+\nL X63.2609 Y42.2601 Z30 FMAX\nL X2.786 Y48.6463 FMAX",
        ),
      ),
    ).toEqual([
      "rapid 0 0 10",
      "feed 61.81 46.247 10 F500",
      "arc 63.261 42.26 10.5 F500",
      "rapid 63.261 42.26 30",
      "rapid 2.786 48.646 30",
    ]));
});
