import { describe, expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { approachContext } from "../edits/approach-context.ts";
import { run } from "./run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const text = (lines: string, unit = "MM") =>
  `0 BEGIN PGM M ${unit}\n1 TOOL DEF 7 R+2\n2 TOOL CALL 7 Z S1000\n3 L X+0 Y+0 Z+10 R0 FMAX\n${lines}\nM30\nEND PGM M ${unit}\n`;
const milled = (lines: string, unit = "MM") => run(parse(text(lines, unit)), { tools: shippedTools, rapid: 10_000 });
type Made = ReturnType<typeof run>;
const round = (n: number) => +n.toFixed(3) + 0;
const path = (r: Made) =>
  r.plane.slice(1).map((s) => {
    const about = s.centre ? ` about ${round(s.centre.x)} ${round(s.centre.y)} ${s.turn}` : "";
    return `${s.kind} ${round(s.to.x)} ${round(s.to.y)} ${s.to.z === null ? "?" : round(s.to.z)}${about}`;
  });
const unproved = (r: Made) => r.unproved.map((u) => `${u.what}@${u.block}`);
const codes = (r: Made) => r.issues.map((f) => `${f.issue.code}@${f.block}`);

const MIRROR_X = "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 X";
const CURVE = "L X+10 Y+5 F100\nCC X+10 Y+8\nC X+13 Y+8 DR+\nCR X+16 Y+11 R+3 DR-\nL IX+2 IY-1";

describe("mirrored", () => {
  test("one axis: coordinates change their sign, increments too, arcs turn the other way", () => {
    const expected = [
      "feed -10 5 10",
      "arc -13 8 10 about -10 8 cw",
      "arc -16 11 10 about -16 8 ccw",
      "feed -18 10 10",
    ];
    expect(path(milled(`${MIRROR_X}\n${CURVE}`))).toEqual(expected);
    expect(path(milled(`TRANS MIRROR AXIS X\n${CURVE}`))).toEqual(expected);
    expect(unproved(milled(`${MIRROR_X}\n${CURVE}`))).toEqual([]);
  });
  test("two axes: arcs keep their way; no axis: as programmed", () => {
    expect(path(milled(`TRANS MIRROR AXIS X Y\n${CURVE}`)).slice(1, 2)).toEqual(["arc -13 -8 10 about -10 -8 ccw"]);
    expect(path(milled(`${MIRROR_X}\nTRANS MIRROR RESET\n${CURVE}`))).toEqual(path(milled(CURVE)));
    expect(path(milled(`TRANS MIRROR AXIS X\nCYCL DEF 8.0 MIRROR\nCYCL DEF 8.1\n${CURVE}`))).toEqual(
      path(milled(CURVE)),
    );
  });
  test("about the datum, wherever that is shifted to", () =>
    expect(path(milled(`TRANS DATUM AXIS X+100 Z-3\n${MIRROR_X}\nL X+10 Y+5 Z+1 F100\nL X+0`))).toEqual([
      "feed 90 5 -2",
      "feed 100 5 -2",
    ]));
  test("the tool changes its side: RL is on the right of the mirrored way, by its own radius", () => {
    const lines = "L X+20 Y+0 RL F100\nL X+40\nL Y+30\nL X+60 R0";
    const [plain, mirrored] = [path(milled(lines)), path(milled(`${MIRROR_X}\n${lines}`))];
    expect(plain).toContain("feed 38 2 10");
    expect(mirrored).toEqual(plain.map((p) => p.replace(/ (\d)/, " -$1").replace(/ about (\S+)/, " about -$1")));
  });
  test("approach and departure are the mirror image, and their dialog counts as the program does", () => {
    const lines =
      "L X-20 Y-20 Z-5 FMAX\nAPPR LCT X+0 Y+0 R+4 RL F100\nL X+30\nL Y+20\nDEP CT CCA90 R+5\nL X-40 Y+50 R0 FMAX";
    const [plain, made] = [milled(lines), milled(`TRANS MIRROR AXIS Y\n${lines}`)];
    expect(made.plane.map((s) => [round(s.to.x), round(-s.to.y)])).toEqual(
      plain.plane.map((s) => [round(s.to.x), round(s.to.y)]),
    );
    const program = parse(text(`TRANS MIRROR AXIS Y\n${lines}`));
    const index = program.blocks.findIndex((b) => b.statement.kind === "approach");
    const { contour, before, side, toolRadius } = approachContext(program, index, made, {});
    expect({ side, toolRadius, before }).toEqual({ side: "left", toolRadius: 2, before: { x: -20, y: -20 } });
    expect(contour[0]).toMatchObject({ from: { x: 0 }, to: { x: 30 } });
    expect(contour[1]?.to.y).toBe(20);
  });
});

describe("turned", () => {
  test("about the datum; one coordinate alone moves in the turned direction; polar angles turn too", () => {
    expect(
      path(milled("TRANS DATUM AXIS X+10 Y+20\nTRANS ROTATION ROT+90\nL X+5 Y+0 F100\nL X+7\nL IY+3\nL Z+4")),
    ).toEqual(["feed 10 25 10", "feed 10 27 10", "feed 7 27 10", "feed 7 27 4"]);
    expect(
      path(milled("CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+30\nCC X+0 Y+0\nLP PR+20 PA+60 F100\nLP IPA+90")),
    ).toEqual(["feed 0 20 10", "feed -20 0 10"]);
    expect(path(milled("TRANS ROTATION ROT+90\nL X+10 Y+0 F100\nCC X+0 Y+0\nCP IPA+90 DR+"))).toEqual([
      "feed 0 10 10",
      "arc -10 0 10 about 0 0 ccw",
    ]);
  });
  test("incremental turns add up, six of 60 degrees are nothing", () => {
    const loop =
      "Q1 = 0\nLBL 1\nTRANS ROTATION IROT+60\nL X+10 Y+0 F100\nQ1 = Q1 + 1\nFN 12: IF +Q1 LT +6 GOTO LBL 1\nL Y+1";
    const made = path(milled(loop));
    expect(made[0]).toBe("feed 5 8.66 10");
    expect(made.slice(-2)).toEqual(["feed 10 0 10", "feed 10 1 10"]);
    expect(
      path(milled("CYCL DEF 10.0 R\nCYCL DEF 10.1 ROT+45\nCYCL DEF 10.0 R\nCYCL DEF 10.1 IROT-45\nL X+3 F1")),
    ).toEqual(["feed 3 0 10"]);
  });
  test("an arc rotated out of its plane is unverified", () => {
    const arc = "L X+12 Y+0 Z+5 F500\nCC X+10 Z+5\nC X+8 Z+5 DR+";
    expect(unproved(milled(`TRANS ROTATION ROT+10\n${arc}`))).toEqual(["C@7"]);
    expect(unproved(milled(`TRANS ROTATION ROT+360\n${arc}`))).toEqual([]);
  });
});

describe("scaled", () => {
  test("lengths, radii and increments, in all axes; never the tool", () => {
    const lines = "L X+10 Y+5 Z+2 F100\nCR X+13 Y+8 R+3 DR+\nL IX+2\nRND R0.5\nL IY+4";
    expect(path(milled(`TRANS SCALE SCL2\n${lines}`))).toEqual([
      "feed 20 10 4",
      "arc 26 16 4 about 20 16 ccw",
      "feed 29 16 4",
      "arc 30 17 4 about 29 17 ccw",
      "feed 30 24 4",
    ]);
    expect(
      path(milled("CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL0.5\nL X+40 Y+0 RL F100\nL X+80\nL Y+60\nL X+0 R0")),
    ).toContain("feed 38 2 10");
    expect(path(milled("CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL0.5\nTRANS SCALE RESET\nL X+40 F1"))).toEqual([
      "feed 40 0 10",
    ]);
  });
  test("cycle 26: each axis about its own centre; what is no circle any more is not proved", () => {
    const head = "CYCL DEF 26.0 AXIS-SPEC. SCALING\nCYCL DEF 26.1 X1.4 Y0.6 CCX+15 CCY+20";
    expect(path(milled(`${head}\nL X+25 Y+10 F100`))).toEqual(["feed 29 14 10"]);
    const arc = "L X+10 Y+5 F100\nCC X+10 Y+8\nC X+13 Y+8 DR+";
    expect(unproved(milled(`${head}\n${arc}`))).toEqual(["C@8"]);
    expect(unproved(milled(`CYCL DEF 26.0 S\nCYCL DEF 26.1 X1.4 Y1.4 Z0.2 CCX+15\n${arc}`))).toEqual([]);
    expect(unproved(milled(`${head}\nL X+10 Y+5 F100\nRND R2\nL X+30`))).toEqual(["RND@7"]);
    expect(path(milled(`CYCL DEF 26.0 S\nCYCL DEF 26.1 X2 CCX+1\nL X+2 F100`, "INCH"))).toEqual(["feed 76.2 0 254"]);
  });
  test.each([
    "TRANS SCALE SCL0",
    "CYCL DEF 11.0 S\nCYCL DEF 11.1 SCL",
    "CYCL DEF 26.0 S\nCYCL DEF 26.1",
    "CYCL DEF 10.0 R\nCYCL DEF 10.1",
  ])("%s has nothing to run", (lines) => expect(unproved(milled(lines))).toHaveLength(1));
});

test("datum, mirror, rotation and scale act in this order, however they are written", () => {
  // (1, 2) scaled (2, 4), turned by 90 degrees (-4, 2), mirrored in X (4, 2), shifted.
  const blocks = ["TRANS SCALE SCL2", "TRANS ROTATION ROT+90", "TRANS MIRROR AXIS X", "TRANS DATUM AXIS X+100 Y+10"];
  for (const order of [
    [0, 1, 2, 3],
    [3, 2, 1, 0],
    [2, 0, 3, 1],
  ])
    expect(path(milled(`${order.map((i) => blocks[i]).join("\n")}\nL X+1 Y+2 F100`))).toEqual(["feed 104 12 10"]);
});

test("a preset resets all of it; what stays active in turning is unverified there", () => {
  expect(
    path(
      milled(
        "CYCL DEF 247 PRESET ~\nQ339=+1\nTRANS MIRROR AXIS X\nTRANS SCALE SCL2\nCYCL DEF 247 PRESET ~\nQ339=+1\nL X+4 F1",
      ),
    ),
  ).toEqual(["feed 4 0 10"]);
  expect(unproved(milled("TRANS MIRROR AXIS Z\nFUNCTION MODE TURN"))).toEqual(["FUNCTION MODE TURN@5"]);
  expect(unproved(milled("TRANS MIRROR AXIS Z\nTRANS MIRROR RESET\nFUNCTION MODE TURN"))).toEqual([]);
  expect(unproved(milled("L X+20 RL F100\nTRANS MIRROR AXIS X\nL X+40\nL Y+3 R0"))).toEqual(["TRANS MIRROR@5"]);
});

test("a shift from a table: its row is named; a turned position is unknown until the shift is known, a mill's path goes on", () => {
  const turned = (lines: string) =>
    run(parse(`BEGIN PGM T MM\nFUNCTION MODE TURN\nTOOL CALL 1\nL X+90 Z+5 FMAX\n${lines}\nM30\nEND PGM T MM`), {
      tools: shippedTools,
      rapid: 10_000,
    });
  const made = turned(
    "TRANS DATUM TABLE TABLINE5\nL X+80 Z+3 FMAX\nL X+70 FMAX\nTRANS DATUM RESET\nL X+60 Z+2 FMAX\nL X+50 FMAX",
  );
  expect(made.steps.map((s) => [s.move.to.z, s.move.to.r])).toEqual([[2, 25]]);
  expect(made.unproved.map((u) => u.what)).toEqual(["TRANS DATUM TABLE TABLINE5"]);
  expect(made.issues.filter((f) => f.issue.severity === "error")).toEqual([]);
  expect(turned("CYCL DEF 7.0 D\nCYCL DEF 7.1 #12\nL X+80 FMAX").unproved.map((u) => u.what)).toEqual([
    "CYCL DEF 7 #12",
  ]);
  expect(
    turned("CYCL DEF 7.0 D\nCYCL DEF 7.1 #12\nTRANS DATUM AXIS X+0 Z-1\nL X+80 Z+1 FMAX").steps.map((s) => s.move.to.z),
  ).toEqual([0]);
  expect(path(milled("TRANS DATUM TABLE TABLINE5\nL X+8 F1"))).toEqual(["feed 8 0 10"]);
});

test.each([
  "PLANE RESET STAY",
  "FUNCTION RESET TCPM",
  "CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.05\nCYCL DEF 32.2 HSC-MODE:0",
  "CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 2.5",
  "CYCL DEF 13.0 ORIENTATION\nCYCL DEF 13.1 ANGLE 180",
  "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+0\nCYCL DEF 7.2 Y+0\nCYCL DEF 7.3 Z+0",
  "TRANS MIRROR RESET\nTRANS ROTATION RESET\nTRANS SCALE RESET",
  "CYCL DEF 247 PRESET ~\nQ339=+4\nCYCL DEF 247 PRESET ~\nQ339=+4",
])("what changes nothing is not reported: %s", (lines) => {
  const said = codes(milled(`${lines}\nL X+5 F100`)).filter((c) => !c.startsWith("blockNumber"));
  expect(said).toEqual([]);
});
