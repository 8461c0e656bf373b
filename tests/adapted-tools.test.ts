import { describe, expect, test } from "vitest";
import type { Tool } from "../src/kernel/plan/tool.ts";
import { toDiameter, degrees, length } from "../src/kernel/units.ts";
import { parse } from "../src/nc/parse.ts";
import { run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import { stockIssues } from "../src/sim/issues.ts";
import { simulate } from "../src/sim/simulate.ts";

const square: Tool = {
  T: 20,
  NAME: "SQUARE-75",
  TYPE: "ROUGH",
  TO: 1,
  RS: length(1.2),
  "T-ANGLE": degrees(75),
  "P-ANGLE": degrees(90),
  CUTLENGTH: length(12),
};
const shop = { tools: [...shippedTools, square], rapid: 10_000 };
const shoulder = [
  "CYCL DEF 812 SHOULDER ~",
  "Q215=+0 ~",
  "Q460=+2 ~",
  "Q491=+75 ~",
  "Q492=+0 ~",
  "Q493=+50 ~",
  "Q494=-55 ~",
  "Q495=+0 ~",
  "Q501=+1 ~",
  "Q502=+0.5 ~",
  "Q500=+1.5 ~",
  "Q496=+0 ~",
  "Q503=+1 ~",
  "Q504=+0.5 ~",
  "Q463=+3 ~",
  "Q478=+0.3 ~",
  "Q483=+0.4 ~",
  "Q484=+0.2 ~",
  "Q505=+0.2 ~",
  "Q506=+0",
];
const contour = (reverse: number) => [
  "CYCL DEF 14.0 CONTOUR",
  "CYCL DEF 14.1 CONTOUR LABEL2",
  "CYCL DEF 820 CONTOUR ~",
  "Q215=+0 ~",
  "Q460=+2 ~",
  `Q499=+${reverse} ~`,
  "Q463=+3 ~",
  "Q478=+0.3 ~",
  "Q483=+0.4 ~",
  "Q484=+0.2 ~",
  "Q505=+0.2 ~",
  "Q487=+1 ~",
  "Q488=+0 ~",
  "Q479=+0 ~",
  "Q480=+0 ~",
  "Q482=+0 ~",
  "Q506=+0",
];
const label = ["LBL 2", "L X+75 Z-20", "L X+50", "RND R2", "L X+20 Z-25", "RND R2", "L Z+0", "LBL 0"];
function cut(tool: number, cycle: readonly string[], x: number) {
  const done = run(
    parse(
      [
        "BEGIN PGM T MM",
        "BLK FORM CYLINDER Z D75 L100 DIST+0",
        "FUNCTION MODE TURN",
        `TOOL CALL ${tool}`,
        "FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500",
        "M136",
        ...cycle,
        `L X+${x} Z+2 R0 FMAX`,
        "CYCL CALL",
        "M30",
        ...label,
        "END PGM T MM",
      ].join("\n"),
    ),
    shop,
  );
  const simulation = simulate(done);
  return {
    done,
    simulation,
    issues: [...done.issues.map((f) => f.issue), ...stockIssues(simulation).map((p) => p.issue)],
  };
}

test("a tool that Q499 = 2 mirrors cuts as the mirrored tool, in the stock too", () => {
  const { done, simulation } = cut(15, contour(2), 20);
  expect(new Set(done.steps.map((s) => s.tool.TO))).toEqual(new Set([7]));
  expect(done.operations[0]?.tool.TO).toBe(1);
  expect(simulation.proof.gouge).toBe(0);
});

test("a contour that begins with a falling wall is finished from the top of the wall", () => {
  const { done, simulation } = cut(8, contour(1), 16);
  const finish = done.steps.filter((s) => s.move.phase === "finish");
  // The tip of the blade is in the middle of its edge, 1.5 mm from the corner that runs down the wall.
  const onWall = finish.find((s) => Math.abs(toDiameter(s.from.r) - 23) < 0.001 && s.move.to.z < -20);
  expect(onWall?.from.z).toBeCloseTo(-0.2, 3);
  expect(simulation.proof.gouge).toBe(0);
  // The pin in front of the first point, 20 mm thick up to Z0, is still there.
  expect(simulation.final.flat().some((p) => Math.abs(toDiameter(p.r) - 20) < 0.01 && p.z > -1)).toBe(true);
});

describe("residue of a sloping edge is attributed to that edge", () => {
  test("a tool set at 75 degrees before a square shoulder", () => {
    const { simulation, issues } = cut(20, shoulder, 75);
    expect(simulation.proof.residual.map((r) => r.reason)).toEqual(["mainEdge"]);
    expect(issues.find((i) => i.code === "angleNotFollowed")).toMatchObject({
      at: "Q496",
      data: { edge: "mainEdge", max: expect.closeTo(15, 6) },
    });
  });
  test("a tool set at 93 degrees on a face that falls by 18 degrees", () => {
    const { issues } = cut(2, contour(0), 75);
    expect(issues.find((i) => i.code === "angleNotFollowed")).toMatchObject({
      data: { edge: "mainEdge", max: expect.closeTo(3, 6) },
    });
    expect(issues.find((i) => i.code === "materialLeft")).toMatchObject({ data: { reason: "mainEdge" } });
  });
});
