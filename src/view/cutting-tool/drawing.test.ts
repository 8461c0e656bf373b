import { describe, expect, test } from "vitest";
import { holderOutlines } from "../../kernel/cutter/holder.ts";
import { insertOutline, isBar } from "../../kernel/cutter/insert.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { length } from "../../kernel/units.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { fitted } from "../camera.ts";
import { ringData } from "../path.ts";
import { svgText } from "../svg.ts";
import { toolBox, toolShapes, type ToolRole } from "./drawing.ts";

const tools = shippedTools.map((tool) => [tool.T, tool] as const);
const [cnmg, blade] = [shippedTools[0], shippedTools[9]] as [Tool, Tool];
const rolesOf = (tool: Tool) => toolShapes(tool).map(({ role }) => role);
const dataOf = (tool: Tool, role: ToolRole) => toolShapes(tool).find((shape) => shape.role === role)?.d;

describe("tools of the table as drawings", () => {
  test.each(tools)("tool %i", async (T, tool) => {
    const box = toolBox(tool),
      size = { width: 320, height: 240 };
    if (!box) throw new Error("no outline");
    const picture = svgText(toolShapes(tool), fitted(box, size, { left: 8, right: 8, top: 8, bottom: 8 }, true), size);
    await expect(picture).toMatchFileSnapshot(`../goldens/tools/${T}-${tool.NAME.toLowerCase()}.svg`);
  });
});

test.each(tools)("tool %i is drawn with its simulated outline, its land inside and its pocket under it", (_, tool) => {
  const roles = rolesOf(tool);
  expect(roles.indexOf("holder")).toBe(0);
  expect(roles.indexOf("pocket")).toBeLessThan(roles.indexOf("insert"));
  expect(roles.indexOf("relief")).toBeGreaterThan(roles.indexOf("insert"));
  expect(dataOf(tool, isBar(tool) ? "rest" : "insert")).toBe(ringData([insertOutline(tool, CHORD)]));
});

test("a tool without a holder has none drawn, and no pocket", () => {
  const { holder: _, ...bare } = cnmg;
  expect(rolesOf(bare)).toEqual(["insert", "relief", "screw", "screw", "drive"]);
});

test("a blade shows the part of its insert that sticks out, and the length of its edge", () => {
  expect(rolesOf(blade)).toEqual(["holder", "pocket", "rest", "insert", "relief"]);
  expect(holderOutlines(blade)).toHaveLength(2);
  // 2 mm wide: 4.8 mm of it.
  expect(dataOf(blade, "insert")).toContain(" 4.8");
  expect(dataOf(blade, "rest")).toContain(" 20");
  const { holder: _, ...bare } = blade;
  expect(rolesOf(bare)).toEqual(["insert", "relief"]);
});

test("an insert with unknown flanks is a guess behind its nose", () => {
  const { "P-ANGLE": _, ...unknown } = cnmg;
  expect(rolesOf(unknown)).toContain("guess");
  expect(rolesOf(unknown)).not.toContain("insert");
});

test("a tool correction moves all shapes", () => {
  const moved = toolBox({ ...cnmg, correction: { z: length(0.31), r: length(-0.17) } }),
    there = toolBox(cnmg);
  expect((moved?.left ?? 0) - (there?.left ?? 0)).toBeCloseTo(0.31, 9);
  expect((moved?.high ?? 0) - (there?.high ?? 0)).toBeCloseTo(-0.17, 9);
});

test("a drill has its axis and its flutes", () => {
  const drill: Tool = { T: 31, NAME: "DRILL-10", TYPE: "DRILL", TO: 9, RS: length(0), R: length(5) };
  expect(rolesOf(drill)).toEqual(["insert", "relief", "centre"]);
});
