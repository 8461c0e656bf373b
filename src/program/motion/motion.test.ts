import { describe, expect, test } from "vitest";
import { toDiameter } from "../../kernel/units.ts";
import { parse } from "../../nc/parse.ts";
import circular from "../../../tests/programs/milling-circular.h?raw";
import linear from "../../../tests/programs/milling-linear.h?raw";
import samples from "../../../tests/programs/approach-departure-tnc7.h?raw";
import { over, readTools } from "../tools/read-tools.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";
import type { Shop } from "../state/shop.ts";

const shop: Shop = { tools: shippedTools, rapid: 10_000 };
const runText = (text: string, more: Partial<Shop> = {}) => run(parse(text), { ...shop, ...more });
/** A milling program with tool radius 5 round some lines, the tool at Z+20. */
const milled = (lines: string, more: Partial<Shop> = {}) =>
  runText(
    `BEGIN PGM T MM\nTOOL DEF 1 L+0 R+5\nTOOL CALL 1 Z S4000\nL Z+20 R0 FMAX\n${lines}\nL Z+20 R0 FMAX M2\nEND PGM T MM\n`,
    more,
  );
const n = (value: number) => Math.round(value * 1e6) / 1e6 + 0;
type Done = ReturnType<typeof run>;
const shown = (done: Done) =>
  done.plane.map(
    (s) =>
      `${s.kind === "arc" ? s.turn : s.kind} ${n(s.to.x)} ${n(s.to.y)} ${s.to.z}${s.feed === undefined ? "" : ` F${s.feed}`}`,
  );
const points = (done: Done, at = 0) =>
  Object.fromEntries(Object.entries(done.approaches[at]?.points ?? {}).map(([name, p]) => [name, [n(p.x), n(p.y)]]));
const faults = (done: Done) =>
  done.issues.filter((f) => f.issue.severity !== "info" && f.issue.code !== "frameMissing").map((f) => f.issue.code);
/** The separate examples of the printed page. */
const fragments = samples.split(/^; --$/m);
const fragment = (i: number) => milled((fragments[i] ?? "").replace(/^;.*$/gm, ""));

describe("the printed square, tool radius 10", () => {
  const done = runText(linear);
  // The first element runs up X+5, the tool stands to its left: PA = (5 − 10, 5), PH 10 mm before it. The last element
  // runs along Y+5 to the left, the tool below: PE = (5, 5 − 10), and DEP LT goes on for 10 mm.
  test("its points", () => {
    expect(points(done)).toEqual({ PS: [-10, -10], PH: [-5, -5], PA: [-5, 5] });
    expect(points(done, 1)).toEqual({ PE: [5, -5], PN: [-5, -5] });
  });
  // Corners: (5, 95) is square, so the arc is a quarter. CHF 10 takes legs of 10: its line runs from (85, 95) to (95,
  // 85) at −45°, moved out by 10 · 0.707107 = 7.071068 on both axes. CHF 20 likewise from (95, 25) to (75, 5).
  test("every move: corners get arcs of 10 mm, chamfers their own feed", () => {
    expect(shown(done)).toEqual([
      "rapid -10 -10 250",
      "feed -10 -10 -5 F1000",
      "feed -5 -5 -5 F1000",
      "feed -5 5 -5 F300",
      "feed -5 95 -5 F300",
      "cw 5 105 -5 F300",
      "feed 85 105 -5 F300",
      "cw 92.071068 102.071068 -5 F300",
      "feed 102.071068 92.071068 -5 F300",
      "cw 105 85 -5 F300",
      "feed 105 25 -5 F300",
      "cw 102.071068 17.928932 -5 F300",
      "feed 82.071068 -2.071068 -5 F300",
      "cw 75 -5 -5 F300",
      "feed 5 -5 -5 F300",
      "feed -5 -5 -5 F1000",
      "rapid -5 -5 250",
    ]);
    for (const s of done.plane)
      if (s.centre) expect(Math.hypot(s.to.x - s.centre.x, s.to.y - s.centre.y)).toBeCloseTo(10, 9);
    expect(faults(done)).toEqual([]);
  });
});

describe("the printed contour with arcs, tool radius 6", () => {
  const done = runText(circular, { mills: [{ T: 1, NAME: "D12", R: 6 }] });
  // PA = (5 − 6, 5); circle R5 to the left: centre C = (−6, 5). PS − C = w = (−4, −15), w² = 241. Counter-clockwise, so
  // PH = C + w · 25/241 + (15, −4) · 5√216/241 = (−1.841202, 2.224320).
  test("APPR LCT", () => expect(points(done)).toEqual({ PS: [-10, -10], PH: [-1.841202, 2.22432], PA: [-1, 5] }));
  // PE = (5, 5 − 6), circle below it: C = (5, −6). PN − C = w = (−25, −14), w² = 821. Counter-clockwise away from PE:
  // PH = C + w · 25/821 − (14, −25) · 5√796/821 = (1.833200, −2.130714).
  test("DEP LCT", () => expect(points(done, 1)).toEqual({ PE: [5, -1], PH: [1.8332, -2.130714], PN: [-20, -20] }));
  // RND R10 round (15, 75) gets 16. CR from (30, 85) to (70, 95), R30: its centre lies on the bisector of the chord,
  // 30² − 425 = 475 below, at (55.285941, 68.856234). Both its corners are inner ones: the circle of 36 meets Y+91 in
  // 55.285941 − √(36² − 22.143766²) = 26.901903 and Y+101 in 55.285941 + √(36² − 32.143766²) = 71.496380. CT from (95,
  // 40): centre on Y+40, radius (55² + 35²) / (2 · 55) = 38.636364; with 44.636364 it meets Y−1 in 56.363636 −
  // √311.404959 = 38.716966.
  test("every move", () => {
    expect(shown(done)).toEqual([
      "rapid -10 -10 250",
      "feed -10 -10 -5 F1000",
      "feed -1.841202 2.22432 -5 F300",
      "ccw -1 5 -5 F300",
      "feed -1 75 -5 F300",
      "cw 15 91 -5 F150",
      "feed 26.901903 91 -5 F300",
      "cw 71.49638 101 -5 F300",
      "feed 95 101 -5 F300",
      "cw 101 95 -5 F300",
      "feed 101 40 -5 F300",
      "cw 38.716966 -1 -5 F300",
      "feed 5 -1 -5 F300",
      "ccw 1.8332 -2.130714 -5 F1000",
      "feed -20 -20 -5 F1000",
      "rapid -20 -20 250",
    ]);
    expect(faults(done)).toEqual([]);
  });
  test("a milling tool of a tools file stands beside turning tools and takes their number", () => {
    const read = readTools('{"tools":[{"T":1,"NAME":"D12","TYPE":"MILL","R":5.5,"DR":0.5}]}');
    if ("problem" in read) throw new Error(read.problem);
    const table = over({ tools: shippedTools }, read);
    expect(table.tools.some((t) => t.T === 1)).toBe(false);
    expect(shown(run(parse(circular), { ...table, rapid: 10_000 }))).toEqual(shown(done));
    expect(readTools('{"tools":[{"T":1,"TYPE":"MILL"}]}')).toMatchObject({
      problem: expect.stringContaining("tools.0.TYPE") as string,
    });
  });
  test("a missing radius is reported, and the path runs as programmed", () => {
    const bare = runText(circular);
    expect(faults(bare)).toEqual(["toolRadiusUnknown"]);
    expect(points(bare)["PA"]).toEqual([5, 5]);
  });
});

describe("the printed examples of each form, tool radius 5", () => {
  // Direction (1, 1)/√2, to its right (0.707107, −0.707107): PA = (20 + 3.535534, 20 − 3.535534), PH 15 mm back.
  test("APPR LT", () =>
    expect(points(fragment(0))).toEqual({ PS: [40, 10], PH: [12.928932, 5.857864], PA: [23.535534, 16.464466] }));
  // Direction (10, 15)/√325, to its right (0.832050, −0.554700): PA = (10, 20) + 5 of it, PH = (10, 20) + 20 of it.
  test("APPR LN", () =>
    expect(points(fragment(1))).toEqual({ PS: [40, 10], PH: [26.641006, 8.905996], PA: [14.160251, 17.226499] }));
  // Pole (50, 20): PA = (20, 20), next (50 + 30 cos 125°, 20 + 30 sin 125°) = (32.792707, 44.574561). Left of that
  // direction is (−0.887011, 0.461749): PA = (20, 20) + 5 of it, PH = (20, 20) + 15 of it.
  test("APPR PLN", () =>
    expect(points(fragment(2))).toEqual({ PS: [-5, 25], PH: [6.694838, 26.926229], PA: [15.564946, 22.308743] }));
  // As LN; half a circle of radius 10 starts 20 mm further out: PH = (10, 20) + 25 of (0.832050, −0.554700).
  test("APPR CT", () => {
    const done = fragment(3);
    expect(points(done)).toEqual({ PS: [40, 10], PH: [30.801257, 6.132495], PA: [14.160251, 17.226499] });
    expect(done.approaches[0]?.arc).toMatchObject({ turn: "cw", radius: 10, angle: 180 });
  });
  // C = (10, 20) + 15 of (0.832050, −0.554700) = (22.480755, 11.679497); w = PS − C = (17.519245, −1.679497), w² =
  // 309.744676. Clockwise: PH = C + w · 100/w² − (1.679497, 17.519245) · 10√(w² − 100)/w² = (27.351509, 2.945898).
  test("APPR LCT", () =>
    expect(points(fragment(4))).toEqual({ PS: [40, 10], PH: [27.351509, 2.945898], PA: [14.160251, 17.226499] }));
  // The element before DEP runs down to (20, 20), the tool to its right at X+15; R8 turns clockwise round (7, 20), half
  // a circle.
  test("DEP CT", () =>
    expect(points(milled("L X+20 Y+35 R0 F300\nL Y+20 RR F100\nDEP CT CCA180 R+8 F100"))).toEqual({
      PE: [15, 20],
      PN: [-1, 20],
    }));
  // Circle round (7, 20); w = (10, 12) − (7, 20) = (3, −8), w² = 73: PH = (7, 20) + w · 64/73 + (8, 3) · 8√9/73.
  test("DEP LCT", () => {
    const done = milled("L X+20 Y+35 R0 F300\nL Y+20 RR F100\nDEP LCT X+10 Y+12 R8 F100");
    expect(points(done)).toEqual({ PE: [15, 20], PH: [12.260274, 13.972603], PN: [10, 12] });
    expect(shown(done).slice(-2)).toEqual(["cw 12.260274 13.972603 20 F100", "feed 10 12 20 F100"]);
  });
  test("older spelling says the same", () => {
    const older = milled(
      "L X+40 Y+10 R0 F300 M3\nAPPR LT X+20 Y+20 Z-10 LEN 15 RR F100\nL X+35 Y+35\nDEP LN LEN+20 F 100",
    );
    expect(points(older)).toEqual(points(fragment(0)));
    // DEP LN: PE = (35, 35) + 5 and PN = (35, 35) + 25 of (0.707107, −0.707107).
    expect(points(older, 1)).toEqual({ PE: [38.535534, 31.464466], PN: [52.67767, 17.32233] });
  });
});

describe("feeds and the tool axis", () => {
  test("LT, LN and CT reach PH at the feed of the previous block, LCT at its own feed", () => {
    expect(shown(fragment(0)).slice(1, 4)).toEqual([
      "feed 12.928932 5.857864 20 F300",
      "feed 12.928932 5.857864 -10 F300",
      "feed 23.535534 16.464466 -10 F100",
    ]);
    expect(shown(fragment(3)).slice(1, 4)).toEqual([
      "rapid 30.801257 6.132495 20",
      "rapid 30.801257 6.132495 -10",
      "cw 14.160251 17.226499 -10 F100",
    ]);
    expect(shown(fragment(4))[1]).toBe("feed 27.351509 2.945898 20 F100");
  });
  test("a TNC7 moves in all axes at once", () => {
    const lines = "L X+40 Y+10 R0 F300\nAPPR LT X+20 Y+20 Z-10 LEN15 RR F100\nL X+35 Y+35\nDEP LT Z+20 LEN15 F100";
    expect(shown(milled(lines, { control: "TNC7" })).slice(1)).toEqual([
      "feed 12.928932 5.857864 -10 F300",
      "feed 23.535534 16.464466 -10 F100",
      "feed 38.535534 31.464466 -10 F100",
      "feed 49.142136 42.071068 20 F100",
    ]);
    expect(shown(milled(lines)).slice(-2)).toEqual([
      "feed 49.142136 42.071068 -10 F100",
      "feed 49.142136 42.071068 20 F100",
    ]);
  });
  test("no feed before is an error, a rapid before is none", () => {
    expect(
      faults(runText("TOOL DEF 1 L+0 R+5\nTOOL CALL 1 Z\nAPPR LT X+20 Y+20 LEN15 RR F100\nL X+35 Y+35\n")),
    ).toContain("feedMissing");
    expect(faults(fragment(3))).toEqual([]);
  });
});

describe("what the control refuses", () => {
  const said = (lines: string) => faults(milled(`L X-40 Y-40 R0 F500\n${lines}`));
  test.each([
    ["R0 in APPR CT", "APPR CT X+0 Y+0 CCA90 R10 R0 F100\nL Y+50\nDEP LT LEN10", ["approachNeedsSide"]],
    ["a polar form without a pole", "APPR PLN PR+30 PA+180 LEN+10 RL F300\nL X+50", ["poleMissing"]],
    ["RL to RR without R0", "APPR LT X+0 Y+0 LEN10 RL F100\nL Y+50\nL X+50 RR\nL Y+90\nL X+200 R0", ["sideChanged"]],
    ["PS in the circle of LCT", "APPR LCT X+0 Y+0 R60 RL F100\nL Y+50\nDEP LT LEN10", ["approachInsideCircle"]],
    [
      "a tool too large for an inside radius",
      "APPR LT X+0 Y+0 LEN10 RR F100\nL Y+50\nRND R4\nL X+50\nL X+90 Y-90 R0",
      ["toolRadiusTooLarge"],
    ],
    ["an approach without a contour", "APPR LT X+0 Y+0 LEN10 RL F100\nL X+50 R0", ["approachWithoutContour"]],
  ])("%s", (_, lines, codes) => expect(said(lines)).toEqual(codes));
  test("the same with R0 between is free", () =>
    expect(
      said("APPR LT X+0 Y+0 LEN10 RL F100\nL Y+50\nDEP LT LEN20\nL X+80 Y+80 R0\nL X+60 Y+60 RR\nL Y+20\nL X+90 R0"),
    ).toEqual([]));
});

describe("path checks that the control does not make", () => {
  const square = "L Y+95\nL X+95\nL Y+5\nL X+5\nDEP LT LEN20 F1000";
  const from = (ps: string) => milled(`L ${ps} R0 FMAX\nL Z-5 F1000\nAPPR LT X+5 Y+5 LEN10 RL F300\n${square}`);
  test("PS on the other side of the part: the place, and a PS from where the way is free", () => {
    const [found] = from("X+120 Y+50")
      .issues.map((f) => f.issue)
      .filter((i) => i.code === "approachCutsContour");
    expect(found?.data).toMatchObject({ point: "PS", depth: expect.any(Number) as number });
    if (found?.code !== "approachCutsContour") return;
    expect(faults(from(`X${found.data.freeX} Y${found.data.freeY}`))).toEqual([]);
  });
  test("a way that passes 2 mm too near", () => {
    // From (110, −2) to PH = (0, −5): next to (95, 5) the tool of 5 mm passes at about 7.4 mm, free; from (110, 3) it
    // cuts in.
    expect(faults(from("X+110 Y-2"))).toEqual([]);
    expect(faults(from("X+110 Y+3"))).toEqual(["approachCutsContour"]);
  });
  test("DEP that goes on into the next wall: a LEN that is free", () => {
    const done = milled(
      "L X-20 Y-20 R0 F500\nAPPR LT X+0 Y+0 LEN10 RR F100\nL Y+60\nL X+50\nL Y+0\nL X+30\nDEP LT LEN40",
    );
    const [found] = done.issues.map((f) => f.issue).filter((i) => i.code === "approachValueCutsContour");
    expect(found?.data).toMatchObject({ point: "PN", word: "LEN" });
    if (found?.code === "approachValueCutsContour") expect(found.data.nearest).toBeLessThan(40);
  });
  test("above the part nothing is cut: the TNC 640 goes to depth in PH", () => {
    const high = (control: Shop["control"]) =>
      faults(
        milled(
          `BLK FORM 0.1 Z X+0 Y+0 Z-20\nBLK FORM 0.2 X+100 Y+100 Z+0\nL X+120 Y+50 R0 FMAX\nAPPR LT X+5 Y+5 Z-5 LEN10 RL F300\n${square}`,
          control ? { control } : {},
        ),
      );
    expect(high("TNC 640")).toEqual([]);
    expect(high("TNC7")).toEqual(["approachCutsContour"]);
  });
});

describe("plain milling", () => {
  test("RL on a line, R0 leaves from where the tool stands", () =>
    expect(shown(milled("L X-20 Y-20 R0 FMAX\nL X+0 Y+0 RL F200\nL Y+50\nL X+50\nL X+80 Y+90 R0")).slice(1)).toEqual(
      [
        "feed -5 0 20 F200",
        "feed -5 50 20 F200",
        "cw 0 55 20 F200",
        "feed 50 55 20 F200",
        "feed 80 90 20 F200",
        "rapid 80 90 20",
      ].slice(0, -1),
    ));
  test("a helix of five turns rises evenly", () => {
    const done = milled("L X+30 Y+0 R0 F300\nCC X+0 Y+0\nCP IPA-1800 IZ+5 DR- F50");
    const arcs = done.plane.filter((s) => s.kind === "arc");
    expect(arcs.map((s) => [n(s.to.x), n(s.to.y), s.to.z])).toEqual([21, 22, 23, 24, 25].map((z) => [30, 0, z]));
  });
  test("DR of the tool call adds to the radius, TOOL DEF to nothing else", () =>
    expect(
      runText("TOOL DEF 1 L+0 R+5\nTOOL CALL 1 Z DR+0.5\nL X+0 Y+0 Z+0 R0 FMAX\nL X+10 RL F100\nL Y+50\nL X+90 R0\n")
        .plane[1]?.to.x,
    ).toBe(4.5));
});

describe("turning with the nose radius", () => {
  const head =
    "BEGIN PGM T MM\nBLK FORM CYLINDER Z D80 L100 DIST+1\nFUNCTION MODE TURN\nTOOL CALL 3\nFUNCTION TURNDATA SPIN VCONST:OFF " +
    "S500\nM136\nL X+50 Z+20 R0 FMAX\n";
  const turned = (lines: string) => runText(`${head}${lines}\nM30\nEND PGM T MM\n`);
  const tips = (done: Done) =>
    done.steps.map(
      (s) => `${s.move.kind === "arc" ? s.move.turn : s.move.kind} ${n(toDiameter(s.move.to.r))} ${n(s.move.to.z)}`,
    );
  // Tool 3: nose 0.4, tip 0.4 to −Z and −X of its centre. Along −Z with RR the centre runs 0.4 above: the tip turns X40
  // exactly. PA: centre (Z0, r 20.4), tip (Z−0.4, X40); PH 5 mm before. The shoulder at Z−30 is an inner corner: centre
  // Z−29.6, tip Z−30. Up the shoulder the centre stays 0.4 in front; DEP LT goes on for 4 mm of radius: X60 + 0.8 − 0.8
  // + 8.
  test("APPR LT, an inner corner, DEP LT: the theoretical tip", () => {
    const done = turned("APPR LT X+40 Z+0 LEN5 RR F0.2\nL Z-30\nL X+60\nDEP LT LEN4");
    expect(tips(done)).toEqual(["rapid 40 4.6", "feed 40 -0.4", "feed 40 -30", "feed 59.2 -30", "feed 67.2 -30"]);
    expect(points(done)).toEqual({ PS: [20, 25], PH: [4.6, 20], PA: [-0.4, 20] });
    expect(faults(done)).toEqual([]);
    expect(done.plane).toEqual([]);
  });
  test("RND grows outside by the nose radius and keeps the tip on the contour's tangents", () =>
    // From the face up Z+0 over R2 to the cylinder X40: RR, the centre runs round (Z−2, r 18) with 2.4.
    expect(
      tips(turned("L X+30 Z+5 F0.3\nL X+30 Z+0 RR F0.2\nL X+40\nRND R2\nL Z-20\nL X+60 R0 F0.4")).slice(1),
    ).toEqual(["feed 29.2 0", "feed 35.2 0", "ccw 40 -2.4", "feed 40 -20.4", "feed 60 -20"]));
});

describe("long paths", () => {
  const zigzag = (count: number) =>
    Array.from(
      { length: count },
      (_, i) => `L X+${i + 1} Y+${i % 2}${i === 0 ? " F500" : ""}${i % 700 === 350 ? "\nRND R0.2" : ""}`,
    );
  test("a path without compensation is carried out piece by piece, with every move and corner as if it were one", () => {
    const done = milled(["L X+0 Y+0 FMAX", ...zigzag(3000)].join("\n"));
    const arcs = done.plane.filter((s) => s.kind === "arc");
    expect(done.unproved).toEqual([]);
    expect(arcs.length).toBe(Math.floor((3000 - 350 - 1) / 700) + 1);
    const moves = done.plane.filter((s) => s.to.z === 20 && s.kind !== "rapid");
    expect(moves.length).toBe(3000 + arcs.length);
    moves.slice(1).forEach((s, i) => expect(s.from).toEqual(moves[i]?.to));
    expect(moves.at(-1)?.to).toMatchObject({ x: 3000, y: 1 });
  });
  test("a compensated contour beyond 20,000 elements ends the run, which says so and leaves the rest unproved", () => {
    const done = milled(
      ["L X+0 Y-20 FMAX", "L X+0 Y+0 RL F500", ...Array.from({ length: 20_100 }, (_, i) => `L X+${i + 1}`)].join("\n"),
    );
    expect(faults(done)).toContain("contourTooLong");
    expect(done.unproved.length).toBe(1);
  });
});
