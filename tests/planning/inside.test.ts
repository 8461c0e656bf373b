import { describe, expect, test } from "vitest";
import { areaOf } from "../../src/kernel/area/area.ts";
import { at } from "../../src/kernel/geometry/point.ts";
import { drillOf } from "../../src/program/tools/drill-of.ts";
import { length } from "../../src/kernel/units.ts";
import { insideRegions } from "../../src/planning/actions/bore.ts";
import { deepestPoint } from "../../src/planning/actions/drill.ts";
import { roughInside } from "../../src/planning/actions/rough-inside.ts";
import { openRegions } from "../../src/planning/open-regions.ts";
import { flippedPart, secondClamping } from "../../src/planning/second-clamping.ts";
import { wholeProgram } from "../../src/planning/whole-program.ts";
import type { PlanState } from "../../src/planning/types.ts";
import { boreParts, type BorePart } from "./bore-parts.ts";
import { workshop } from "./bore-tools.ts";
import { greedyPlan, judged, programOf, requestFor } from "./greedy.ts";

function partNamed(name: string): BorePart {
  const found = boreParts.find(({ part }) => part.name === name);
  if (!found) throw new Error(`no ${name}`);
  return found;
}

function drillNamed(name: string) {
  const row = workshop.mills.find(({ NAME }) => NAME === name);
  const tool = row && drillOf(row);
  if (!tool) throw new Error(`no ${name}`);
  return tool;
}

/** Each plan is made once. */
const plans = new Map<string, PlanState>();
function planOf(name: string): PlanState {
  const { part, blank } = partNamed(name);
  const plan = plans.get(name) ?? greedyPlan(requestFor(part, blank));
  plans.set(name, plan);
  return plan;
}

const kindsOf = ({ done }: PlanState) => new Set(done.map(({ action }) => action.kind));
/** A part with something that no bar reaches from the front. */
const FROM_BEHIND = "bothEnds";

describe("the first action that works, again and again, makes the inside", () => {
  test.each(boreParts.map((each) => [each.part.name, each] as const))("of a %s", (name, { part, blank, threads }) => {
    const request = requestFor(part, blank);
    const state = planOf(name);
    expect(state.done.every(({ gouge, faults }) => gouge < 0.01 && faults.length === 0)).toBe(true);
    if (name !== FROM_BEHIND) expect(insideRegions(state.stock, part)).toEqual([]);
    expect(threads.every((thread) => [...state.threads].some((made) => made.startsWith(thread)))).toBe(true);
    expect(state.threads.size).toBe(threads.length);
    const { verdict, findings, stock } = judged(programOf(state, request), request);
    expect(findings).toEqual([]);
    expect(verdict).toBe("proved");
    if (threads.length === 0) expect(areaOf(stock)).toBeCloseTo(areaOf(state.stock), 1);
  });
});

test.each([
  ["groove", ["recess", "finishInside"]],
  ["centred", ["centre"]],
  ["nut", ["drill", "thread"]],
  ["long", ["centre", "drill"]],
  ["blind", ["drill", "roughInside", "finishInside"]],
] as const)("a %s needs %j", (name, kinds) => {
  expect([...kindsOf(planOf(name))]).toEqual(expect.arrayContaining([...kinds]));
});

test("a short hole is drilled without a centre", () => {
  expect(kindsOf(planOf("nut"))).not.toContain("centre");
});

describe("a drill goes as deep as its own shape lets it", () => {
  test.each([
    // A flat bottom: with its point on it.
    ["blind", "DRILL-D20", 0.25, -35],
    // A shoulder: with its point below it, as far as the narrower bore takes the point.
    ["stepped", "DRILL-D20", 0.25, -35.276],
    // Through: its full radius behind the rear end.
    ["stepped", "DRILL-D16", 0.25, -50 - 4.807 - 2],
    // As wide as the bore, without a tolerance: it makes the bore with its conical bottom.
    ["relieved", "DRILL-D20", 0.25, -46.009],
    // Smaller than the bore: it makes the bottom on the axis all the same, which no bar reaches.
    ["relieved", "DRILL-D16", 0.25, -46.009],
    // Too wide.
    ["nut", "DRILL-D12", 0.25, null],
  ] as const)("of a %s: %s", (name, drill, allowance, depth) => {
    const found = deepestPoint(drillNamed(drill), partNamed(name).part, allowance);
    if (depth === null) expect(found).toBeNull();
    else expect(found).toBeCloseTo(depth, 2);
  });
});

describe("bars", () => {
  const { part, blank } = partNamed("bush");
  const bored = (r: number) => [[at(-70, r), at(0, r), at(0, 26), at(-70, 26)]];
  const toolsFor = (stock: PlanState["stock"], tools = workshop.tools) => {
    const request = requestFor(part, blank, { shop: { ...workshop, tools } });
    const actions = roughInside.actions({ stock, done: [], threads: new Set() }, request);
    return [...new Set(actions.map(({ tool }) => tool.T))];
  };

  test("need a bore that their body enters", () => {
    expect(toolsFor(blank)).toEqual([]);
    expect(toolsFor(bored(4))).toEqual([]);
    expect(toolsFor(bored(6))).toEqual([53]);
    expect(toolsFor(bored(12))).toContain(5);
  });

  test("respect the least bore of their row", () => {
    const tools = workshop.tools.map((tool) => (tool.T === 53 ? { ...tool, DMIN: length(13) } : tool));
    expect(toolsFor(bored(6), tools)).toEqual([]);
  });
});

describe("the second clamping", () => {
  const { part, blank } = partNamed(FROM_BEHIND);
  const request = requestFor(part, blank);

  test("makes what only the rear reaches, held on a finished cylinder", () => {
    const first = planOf(FROM_BEHIND);
    expect(openRegions(first.stock, part).length).toBeGreaterThan(0);
    const second = secondClamping(request, first, programOf(first, request));
    if (!second) throw new Error("no second clamping");
    expect(second.clamping?.clamping).toMatchObject({ kind: "softJaws" });
    expect(second.clamping?.clamping.diameter).toBeCloseTo(40, 1);
    const state = greedyPlan(second);
    expect(openRegions(state.stock, second.part)).toEqual([]);
    const actions = state.done.map(({ action }) => action);
    const { judged: found, stock, gouge } = wholeProgram(actions, second);
    expect(found.verdict).toBe("proved");
    expect(gouge).toBeLessThan(0.01);
    expect(areaOf(stock)).toBeCloseTo(areaOf(part.rings), 0);
  });

  test("is not needed for a bar part, nor for a finished one", () => {
    const program = programOf({ stock: [], done: [], threads: new Set() }, request);
    const state = { stock: blank, threads: new Set<string>() };
    expect(secondClamping({ ...request, partsOff: true }, state, program)).toBeNull();
    expect(secondClamping(request, { ...state, stock: part.rings }, program)).toBeNull();
  });

  test("leaves threads that are made", () => {
    const nut = partNamed("nut");
    const asked = requestFor(nut.part, nut.blank);
    const state = { stock: nut.blank, threads: new Set(["M10 -1.5"]) };
    const second = secondClamping(asked, state, programOf({ ...state, done: [] }, asked));
    expect(second?.part.inside.marks.some(({ thread }) => thread !== undefined)).toBe(false);
  });

  test.each(boreParts.map(({ part: each }) => [each.name, each] as const))("a %s turned twice", (_, each) => {
    const twice = flippedPart(flippedPart(each));
    expect(areaOf(twice.rings)).toBeCloseTo(areaOf(each.rings), 6);
    expect(twice.outside.segments.at(-1)?.to).toEqual(each.outside.segments.at(-1)?.to);
    const isThrough = (each.inside.segments.at(-1)?.to.r ?? 0) > 0;
    expect(twice.inside.segments.length).toBe(isThrough ? each.inside.segments.length : 0);
  });
});
