import { describe, expect, test } from "vitest";
import { bridgedOver, isValley, pocketsOf } from "../../src/planning/actions/pockets.ts";
import type { PlanRequest } from "../../src/planning/types.ts";
import type { WorkingPlan } from "../../src/planning/working-plan.ts";
import { partOfTrade } from "./parts.ts";
import { planOf, requestOf, withOwnTools } from "./plan-laws.ts";

const of = (name: string): PlanRequest => {
  const request = requestOf(partOfTrade(name));
  if (!request) throw new Error(name);
  return request;
};

describe("grooves and valleys of a part, by their mouth", () => {
  test.each([
    ["bearing-seat", ["groove -3.46 -5.13", "valley -21.5 -24.12", "valley -55.5 -57.92"]],
    ["pulley", ["groove -2.79 -13.21", "groove -14.79 -25.21"]],
    ["piston", ["groove -7.8 -13", "groove -17.65 -24.35", "groove -29 -34.2"]],
    ["spool", ["valley -12 -57.86"]],
  ])("%s", (name, expected) => {
    const place = (n = 0) => Number(n.toFixed(2));
    const { outside } = of(name).part;
    const found = pocketsOf(outside, "r").map((pocket) => {
      const [front, rear] = [pocket.segments[0]?.from.z, pocket.segments.at(-1)?.to.z];
      return `${isValley(pocket) ? "valley" : "groove"} ${place(front)} ${place(rear)}`;
    });
    expect(found).toEqual(expected);
  });
});

test("the ways over the two pockets of an undercut F meet in the corner that it undercuts", () => {
  const { outside } = of("bearing-seat").part;
  const bridged = bridgedOver(outside, [...pocketsOf(outside, "r"), ...pocketsOf(outside, "z")]);
  const ends = bridged.segments.map(({ to }) => `${to.z.toFixed(1)} ${to.r.toFixed(1)}`);
  expect(ends).toContain("-24.0 17.5");
  expect(bridged.segments.every(({ from }, i) => i === 0 || from === bridged.segments[i - 1]?.to)).toBe(true);
});

/** What is left, in a line each: why, and the smallest data of the tool. */
const leftOf = ({ residue }: WorkingPlan) => residue.map(({ why, missing }) => ({ why, ...missing }));

describe("what is left names its tool", () => {
  test.each([
    [
      "bearing-seat",
      [
        { why: "tool", form: "recessing", site: "outside", mostWidth: 1.67, leastDepth: 1, mostNose: 0.48 },
        { why: "tool", form: "turning", site: "outside", hand: "right", descends: 15, leastEdge: 98, mostNose: 0.6 },
      ],
    ],
    ["pulley", [{ why: "tool", form: "recessing", site: "outside", leastDepth: 40 }]],
  ])("%s", (name, expected) => expect(leftOf(planOf(withOwnTools(of(name))))).toEqual(expected));
});

test("a bored part is parted off through its wall, with what is not made before", () => {
  const { steps, residue } = planOf(withOwnTools(of("piston")));
  const last = steps.at(-1);
  expect(last?.tried.action.kind).toBe("partOff");
  expect(last?.why).toContainEqual({ kind: "unfinished", area: expect.closeTo(34, 0) as number, threads: [] });
  expect(residue.map(({ site, why }) => [site, why])).toEqual([["inside", "tool"]]);
  expect(steps.map(({ tried }) => tried.action.kind)).not.toContain("restRough");
});

test("the second clamping states its jaws, calls its own tools, and cuts the thread of its side", () => {
  const plan = planOf(withOwnTools(of("nozzle")));
  const { second } = plan;
  if (!second) throw new Error("no second clamping");
  expect(second.judged.verdict).toBe("proved");
  expect(second.text).toMatch(/; CLAMPING SOFT JAWS D26/);
  expect(second.text.match(/TOOL CALL/g)).toHaveLength(second.steps.length);
  expect(second.steps.flatMap(({ tried }) => tried.action.threads)).toEqual(["M30x1.5 0"]);
  expect(plan.residue.map(({ site, why }) => `${site} ${why}`)).toEqual([
    "inside tool",
    "outside rear",
    "outside rear",
  ]);
});
