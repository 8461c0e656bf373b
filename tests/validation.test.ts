import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../src/cycles/index.ts";
import { contourFrom } from "../src/kernel/contour/contour.ts";
import type { Issue } from "../src/kernel/plan/issue.ts";
import type { Tool } from "../src/kernel/plan/tool.ts";
import { feed } from "../src/kernel/units.ts";
import { exampleDraft, readDraft } from "../src/program/job/read-draft.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import { betterTool } from "../src/program/tools/which-tool.ts";
import { at, type Case, printed, rules } from "./validation-rules.ts";

const shipped = (T: number): Tool => shippedTools.find((tool) => tool.T === T) as Tool;

const usual: Readonly<Record<number, number>> = { 812: 1, 820: 15, 852: 8 };

function check(number: number, { change = {}, tool, start = [75, 2], contour = printed }: Case) {
  const cycle = cycleByNumber(number);
  if (!cycle) throw new Error(`no cycle ${number}`);
  const base = shipped(tool?.T ?? usual[number] ?? 1);
  const built = contourFrom(contour);
  const setting = {
    tool: { ...base, ...tool },
    start: at(start[0], start[1]),
    feedUnit: "mm/rev" as const,
    autoFeed: feed(0.25),
    stock: null,
  };
  const given = { contour: built.segments, start: null };
  const reading = readDraft(cycle, { ...exampleDraft(cycle), ...change });
  const outline = reading.values && cycle.outline(reading.values, given);
  const plan = reading.values && cycle.plan(reading.values, setting, given);
  const issues = [...built.issues, ...reading.issues, ...(outline?.issues ?? []), ...(plan?.issues ?? [])];
  return { cycle, setting, given, reading, plan, issues };
}

const codes = (issues: readonly Issue[]) => issues.map((found) => `${found.code} ${found.at ?? ""}`.trim());
const nearestOf = (found: Issue): number | null => ("nearest" in found.data ? found.data.nearest : null);

describe.each(rules.map((rule) => [`${rule.name} (${rule.cycle} ${rule.code})`, rule] as const))("%s", (_, rule) => {
  test("is found", () => {
    const { issues } = check(rule.cycle, rule.trips);
    expect(codes(issues)).toContain(`${rule.code} ${rule.field}`);
    expect(issues.find((i) => i.code === rule.code && i.at === rule.field)?.severity).toBe(rule.severity);
  });

  test("is not found in the similar case", () => {
    expect(codes(check(rule.cycle, rule.passes).issues)).not.toContain(`${rule.code} ${rule.field}`);
  });

  test("proposes a value that works", () => {
    const found = check(rule.cycle, rule.trips).issues.find((i) => i.code === rule.code && i.at === rule.field);
    const nearest = found ? nearestOf(found) : null;
    if (nearest === null || rule.nearestElsewhere) return;
    const mended = check(rule.cycle, {
      ...rule.trips,
      change: { ...rule.trips.change, [rule.field]: String(nearest) },
    });
    expect([nearest, codes(mended.issues)]).not.toEqual([
      nearest,
      expect.arrayContaining([`${rule.code} ${rule.field}`]),
    ]);
  });
});

describe("the printed examples", () => {
  test.each([812, 820, 852])("%i has no error with its usual tool", (number) => {
    const { issues, plan } = check(number, {});
    expect(issues.filter((found) => found.severity === "error")).toEqual([]);
    expect(plan?.moves.length).toBeGreaterThan(0);
  });
});

describe("a tool that cannot make the contour", () => {
  test.each([
    [812, 5, 1],
    [820, 1, 15],
    [852, 1, 8],
  ])("cycle %i with tool %i: tool %i is the usual one", (number, T, usualOne) => {
    const { cycle, reading, given, setting } = check(number, { tool: { T } });
    expect(reading.values && betterTool(cycle, reading.values, given, setting, shippedTools)?.T).toBe(usualOne);
  });

  test.each([
    [820, 1],
    [820, 5],
    [852, 1],
    [852, 10],
    [812, 5],
    [812, 8],
  ])("cycle %i with tool %i: one that can is named", (number, T) => {
    const { cycle, reading, given, setting } = check(number, { tool: { T } });
    if (!reading.values) throw new Error("the example reads");
    const better = betterTool(cycle, reading.values, given, setting, shippedTools);
    expect(better).not.toBeNull();
    const best = check(number, { tool: { T: better?.T ?? 0 } });
    expect(codes(best.issues.filter((found) => found.severity === "error"))).toEqual([]);
    expect(codes(best.issues)).not.toContain("angleNotFollowed contour");
  });
});
