import { describe, expect, test } from "vitest";
import { readDraft } from "../../program/job/read-draft.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import type { ShapeRequest } from "../../cycles/shape-request.ts";
import { useOf } from "../../cycles/use.ts";
import { axial, diameter, length } from "../../kernel/units.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { bestFirst, bestOf } from "./best.ts";
import { tryWay } from "./try-way.ts";
import { waysFor } from "./ways.ts";

const shop = { tools: shippedTools, rapid: 10_000 };
const corner = (d: number, z: number) => ({ diameter: diameter(d), z: axial(z) });
const wanted = (given: Partial<ShapeRequest>): ShapeRequest => ({
  site: "outside",
  shape: "step",
  from: corner(75.3, 0),
  to: corner(48.71, -41.237),
  angle: 0,
  pitch: 1.75,
  contour: null,
  allowance: 0,
  ...given,
});
const compared = (of: ShapeRequest) => {
  const ways = waysFor(of, null, shippedTools);
  return { ways, tried: ways.map((way) => tryWay(way, of, null, shop)) };
};

describe("the ways that are proposed", () => {
  const asked: readonly (readonly [string, Partial<ShapeRequest>])[] = [
    ["a step outside", {}],
    ["a tapered step", { angle: 3.217 }],
    ["a step in a bore", { site: "inside", from: corner(30.3, 0), to: corner(48.71, -21.237) }],
    ["a step on a face", { site: "face", to: corner(48.71, -7.313) }],
    ["a groove outside", { shape: "groove", from: corner(75.3, -20.31), to: corner(58.77, -32.123) }],
    ["a groove in a bore", { site: "inside", shape: "groove", from: corner(40.3, -20.31), to: corner(47.71, -29.123) }],
    ["a thread", { shape: "thread", from: corner(30, 0), to: corner(30, -25.3) }],
    ["a thread in a bore", { site: "inside", shape: "thread", from: corner(42, 0), to: corner(42, -18.3) }],
    ["a groove in a face", { site: "face", shape: "groove", to: corner(48.71, -9.231) }],
  ];
  test.each(asked)("%s has a verified option, and two to compare", (_, given) => {
    const { ways, tried } = compared(wanted(given));
    expect(ways.length).toBeGreaterThan(1);
    expect(ways.length).toBeLessThanOrEqual(8);
    expect(new Set(ways.map((way) => way.id)).size).toBe(ways.length);
    expect(bestOf(tried)).not.toBeNull();
    const best = bestFirst(tried)[0];
    expect(best?.residualArea ?? 0).toBeLessThan(0.2);
    expect(best?.passes).toBeGreaterThan(0);
  });

  test("each has values that its own cycle takes", () => {
    for (const { job } of waysFor(wanted({}), null, shippedTools)) {
      const cycle = cycleByNumber(job.cycle);
      expect(cycle && readDraft(cycle, job.drafts[job.cycle] ?? {}).issues).toEqual([]);
    }
  });

  test("both choices of a cycle and two tools stand side by side", () => {
    const ways = waysFor(wanted({}), null, shippedTools);
    const [first] = ways;
    const same = ways.filter((way) => way.job.cycle === first?.job.cycle);
    expect(new Set(same.map((way) => way.choice?.value)).size).toBe(2);
    expect(new Set(ways.map((way) => way.tool.T)).size).toBeGreaterThan(1);
  });
});

test("a roughing insert is best for a deep cut, whatever its radius leaves in the corner", () => {
  const { ways, tried } = compared(wanted({}));
  const typeOf = (id: string) => ways.find((way) => way.id === id)?.tool.TYPE;
  const [best, ...rest] = bestFirst(tried);
  expect(typeOf(best?.id ?? "")).toBe("ROUGH");
  const finishing = rest.filter(({ id }) => typeOf(id) === "FINISH");
  expect(finishing.length).toBeGreaterThan(0);
  expect(finishing.every(({ suitsDepth, works }) => works && !suitsDepth)).toBe(true);
  for (const other of rest.filter((each) => each.works && each.suitsDepth)) {
    const more = other.unreached - (best?.unreached ?? 0);
    expect(more > 0.05 || other.seconds >= (best?.seconds ?? 0) * 0.99).toBe(true);
  }
});

test("solid material is not turned by passes that follow a contour", () => {
  const preTurned = (of: ShapeRequest) =>
    waysFor(of, null, shippedTools).some(({ job }) => {
      const cycle = cycleByNumber(job.cycle);
      return cycle !== undefined && useOf(cycle).preTurned === true;
    });
  expect(preTurned(wanted({}))).toBe(false);
  expect(preTurned(wanted({ allowance: length(2.1) }))).toBe(true);
});

test("a step with a chamfer is made by the cycle that has a starting element, and by a contour", () => {
  const { ways, tried } = compared(wanted({ chamfer: length(1.7) }));
  const own = ways.filter(({ job }) => cycleByNumber(job.cycle)?.contour === "own");
  expect(own.length).toBeGreaterThan(0);
  for (const { job } of own) expect(job.drafts[job.cycle]).toMatchObject({ Q501: "1", Q502: "1.7" });
  expect(bestFirst(tried)[0]?.works).toBe(true);
  expect(bestFirst(tried)[0]?.unreached).toBeLessThan(0.05);
});

test.each([
  ["only", []],
  ["tool", [{ suitsDepth: false, seconds: 1 }]],
  ["least", [{ unreached: 0.3, seconds: 1 }]],
  ["fast", [{ seconds: 12 }]],
  ["passes", [{ seconds: 10.05, passes: 9 }]],
  ["equal", [{ seconds: 10 }]],
] as const)("the reason for the best is said: %s", (because, others) => {
  const { tried } = compared(wanted({}));
  const [base] = tried;
  if (!base) throw new Error("nothing tried");
  const plain = { ...base, works: true, suitsDepth: true, unreached: 0, seconds: 10, passes: 5 };
  const all = [{ ...plain, id: "a" }, ...others.map((other) => ({ ...plain, ...other, id: "b" }))];
  expect(bestOf(all)).toEqual({ id: "a", because });
});

test("a groove narrower than every tool says so with each way", () => {
  const { tried } = compared(wanted({ shape: "groove", from: corner(75.3, -20.31), to: corner(68.7, -21.123) }));
  expect(bestOf(tried)).toBeNull();
  for (const { issues, works } of tried) {
    expect(works).toBe(false);
    expect(issues.map((i) => i.code)).toContain("recessNarrowerThanTool");
  }
});

test("a near-net-shape blank is turned faster by contour-parallel passes", () => {
  const of = wanted({ to: corner(58.71, -41.237), allowance: length(2.3) });
  const { ways, tried } = compared(of);
  const follows = (id: string) => {
    const cycle = cycleByNumber(ways.find((way) => way.id === id)?.job.cycle ?? 0);
    return cycle !== undefined && useOf(cycle).preTurned === true;
  };
  const fastest = (ids: readonly string[]) =>
    Math.min(...tried.filter((t) => t.works && ids.includes(t.id)).map((t) => t.seconds));
  const ids = ways.map((way) => way.id);
  expect(fastest(ids.filter(follows))).toBeLessThan(fastest(ids.filter((id) => !follows(id))));
  const solid = compared(wanted({ to: corner(58.71, -41.237) })).tried;
  expect(solid.every((each) => each.seconds > fastest(ids))).toBe(true);
});

test("a holder that hits a wall higher than its insert is no option", () => {
  const { tried } = compared(wanted({ to: corner(20.3, -41.237), allowance: length(3.1) }));
  const [worst] = bestFirst(tried).slice(-1);
  expect(worst?.judged.reasons.map((r) => r.kind)).toContain("holderContact");
});
