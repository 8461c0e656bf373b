import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../../cycles/index.ts";
import { parse } from "../../nc/parse.ts";
import { print, type Program } from "../../nc/program.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { degrees, length, radius, toDiameter } from "../../kernel/units.ts";
import { verdictOf } from "../../report/verdict.ts";
import { producedParts } from "../../sim/produced-parts.ts";
import { simulate } from "../../sim/simulate.ts";
import { emptyProgram } from "../job/empty-program.ts";
import { exampleJob, type SetJob } from "../job/job.ts";
import { surfacesOf } from "../job/stock-surface.ts";
import { run } from "../run/run.ts";
import { drillOf } from "../tools/drill-of.ts";
import { standardDrills } from "../tools/standard-drills.ts";
import { readList, shippedList } from "../tools/tool-list.ts";
import { shippedTools } from "../tools/shipped-tools.ts";
import { withHandOperation } from "./added-operation.ts";
import { canDo, handCut, speedOnAxis, type HandWork } from "./hand-operation.ts";

const drill: Tool = {
  ...toolOf(1),
  T: 31,
  NAME: "DRILL",
  TYPE: "DRILL",
  TO: 8,
  RS: length(0),
  R: length(5),
  "P-ANGLE": degrees(118),
  CUTLENGTH: length(80),
};
const tap: Tool = { ...drill, T: 32, NAME: "TAP", TYPE: "TAP", PITCH: length(1.25) };
const shop = { tools: [...shippedTools, drill, tap], rapid: 10_000 };

function toolOf(T: number): Tool {
  const tool = shippedTools.find((each) => each.T === T);
  if (!tool) throw new Error(`no tool ${T}`);
  return tool;
}

/** A standard centre drill as a tool on the axis. */
function centreTool(name: string): Tool {
  const row = readList(standardDrills(shippedList).map((cells, i) => ({ id: `c${i}`, cells }))).table.mills?.find(
    ({ NAME }) => NAME === name,
  );
  const tool = row && drillOf(row);
  if (!tool) throw new Error(`no ${name}`);
  return tool;
}

function added(program: Program, work: HandWork, tool: Tool, sizes = { size: 0, z: 0 }, inside = false): Program {
  const stock = simulate(run(program, shop)).final;
  const [surface] = surfacesOf(stock, inside ? "inside" : "outside");
  const cycle = cycleByNumber(812);
  if (!surface || !cycle) throw new Error("no surface");
  const { start, cut } = handCut(work, { stock, surface, tool, sizes });
  const job: SetJob = {
    ...exampleJob(cycle),
    tool: tool.T,
    start,
    blank: { outside: "60.2", bore: inside ? "28.4" : "0", length: "70", allowance: "0" },
  };
  return parse(print(withHandOperation(program, job, cut, { title: work })));
}

const blank = (bore: string) => parse(emptyProgram("A", { outside: "60.2", bore, length: "70", allowance: "0" }));
const finalOf = (program: Program) => {
  const made = run(program, shop);
  expect(made.issues.filter(({ issue }) => issue.severity === "error")).toEqual([]);
  const simulation = simulate(made);
  expect(simulation.findings).toEqual([]);
  return { made, simulation, points: producedParts(simulation).flat() };
};
const has = (points: readonly { z: number; r: number }[], d: number, z: number) =>
  points.some((p) => Math.abs(toDiameter(radius(p.r)) - d) < 0.01 && Math.abs(p.z - z) < 0.01);

describe("an operation without a cycle", () => {
  test.each([
    ["outside", "0", 1, false, 60.2 - 2 * 1.7],
    ["inside", "28.4", 5, true, 28.4 + 2 * 1.7],
  ] as const)("a chamfer %s has its size whatever the nose radius", (_, bore, T, inside, across) => {
    const { points } = finalOf(added(blank(bore), "chamfer", toolOf(T), { size: 1.7, z: 0 }, inside));
    expect(has(points, across, 0)).toBe(true);
    expect(has(points, inside ? 28.4 : 60.2, -1.7)).toBe(true);
  });

  test.each([
    ["CENTER-A4", 8.5, 8.5, 4, -8.897],
    ["CENTER-A2.5", 5.3, 5.3, 2.5, -5.525],
    ["CENTER-B4", 12.5, 8.5, 4, -10.052],
    ["CENTER-R4", 8.5, 8.5, 4, -7.4],
  ])("%s leaves its mouth, cones and pilot", (name, mouth, d2, d1, bottom) => {
    const centre = centreTool(name);
    const made = run(added(blank("0"), "centre", centre), { ...shop, tools: [...shippedTools, centre] });
    expect(made.issues.filter(({ issue }) => issue.severity !== "info")).toEqual([]);
    const simulation = simulate(made);
    expect(simulation.findings).toEqual([]);
    const points = producedParts(simulation).flat();
    expect(has(points, mouth, 0)).toBe(true);
    const below = (mouth - d2) / 2 / Math.tan(Math.PI / 3);
    expect(has(points, d2, -below)).toBe(true);
    expect(has(points, d1, -below - (d2 - d1) / 2 / Math.tan(Math.PI / 6))).toBe(true);
    expect(has(points, 0, bottom)).toBe(true);
  });

  test.each([
    [-6, "centreMouth"],
    [-8.9, null],
    [-10, "centreMouth"],
  ])("a centre hole A4 drilled to %s", (depth, code) => {
    const centre = centreTool("CENTER-A4");
    const program = parse(print(added(blank("0"), "centre", centre)).replace(/Q201=-8\.898/, `Q201=${depth}`));
    const { issues } = run(program, { ...shop, tools: [...shippedTools, centre] });
    expect(issues.filter(({ issue }) => issue.severity !== "info").map(({ issue }) => issue.code)).toEqual(
      code === null ? [] : [code],
    );
  });

  test.each(["partOff", "partOffChamfered"] as const)("%s leaves the part with its rear face", (work) => {
    const { points } = finalOf(added(blank("28.4"), work, toolOf(10), { size: 1.3, z: -33.1 }));
    const chamfered = work === "partOffChamfered";
    expect(has(points, chamfered ? 60.2 - 2.6 : 60.2, -33.1)).toBe(true);
    expect(has(points, 60.2, -33.1 + (chamfered ? 1.3 : 0))).toBe(true);
  });

  test.each([
    ["drill", drill],
    ["tap", tap],
  ] as const)("%s: the depth stays open, and nothing is verified before it is typed", (work, tool) => {
    const program = added(blank("8"), work, tool);
    const open = run(program, shop);
    expect(verdictOf(open, simulate(open)).verdict).not.toBe("proved");
    const text = print(program);
    expect(text).toMatch(/Q201= ;/);
    const typed = run(parse(text.replace("Q201= ;", "Q201=-20 ;")), shop);
    expect(typed.issues.filter(({ issue }) => issue.severity === "error")).toEqual([]);
    expect(Math.min(...typed.steps.map(({ move }) => move.to.z))).toBeCloseTo(-20, 3);
  });

  test("a drill turns at the speed of its diameter", () => {
    expect(speedOnAxis("drill", drill)).toBe(1910);
    expect(speedOnAxis("tap", tap)).toBe(380);
  });

  test("only tools that can do it are offered", () => {
    const able = (work: HandWork, isInside = false, depth = 0) =>
      shop.tools.filter((tool) => canDo(work, tool, { isInside, depth })).map(({ T }) => T);
    expect(able("chamfer")).toEqual([1, 2, 3, 4, 15]);
    expect(able("chamfer", true)).toEqual([5, 6]);
    expect(able("partOff", false, 15)).toEqual([9, 10]);
    expect(able("partOff", false, 25)).toEqual([9]);
    expect(able("partOff", false, 31)).toEqual([]);
    expect(able("drill")).toEqual([31]);
    expect(able("tap")).toEqual([32]);
    expect(able("peck")).toEqual([31]);
    expect(able("ream")).toEqual([]);
  });
});
