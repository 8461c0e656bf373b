import { describe, expect, test } from "vitest";
import { intersection, offset } from "../../src/kernel/area/clip.ts";
import { roughOutside } from "../../src/planning/actions/rough-outside.ts";
import { applyAction } from "../../src/planning/apply-action.ts";
import type { PlanRequest } from "../../src/planning/types.ts";
import { PART_NAMES, partOfTrade } from "./parts.ts";
import { planOf, requestOf } from "./plan-laws.ts";

/** The cycle whose passes follow the contour. */
const ALONG = 815;

const fromBar = (name: string): PlanRequest => {
  const request = requestOf(partOfTrade(name));
  if (!request) throw new Error(name);
  return request;
};

/** A part from a forging that follows it at a distance, mm. */
const forged = (name: string, allowance: number): PlanRequest => {
  const request = fromBar(name);
  return { ...request, blank: intersection(request.blank, offset(request.part.rings, allowance)) };
};

const stateOf = ({ blank }: PlanRequest) => ({ stock: blank, done: [], threads: new Set<string>() });
const waysIn = (request: PlanRequest) => roughOutside.actions(stateOf(request), request);

describe("a forging can be roughed along its contour", () => {
  test.each([
    ["bearing-seat", 3],
    ["bearing-seat", 1.5],
    ["shaft", 3],
    ["shaft", 2],
  ] as const)("%s, %d mm, in less time for no less material", (name, allowance) => {
    const request = forged(name, allowance);
    const tried = waysIn(request).map((action) => applyAction(action, stateOf(request), request));
    const [along, others] = [true, false].map((is) =>
      tried
        .filter(({ works, action }) => works && (action.cycle === ALONG) === is)
        .toSorted((a, b) => a.seconds - b.seconds),
    );
    expect(along?.[0]?.seconds).toBeLessThan(others?.[0]?.seconds ?? 0);
    expect(along?.[0]?.cut).toBeGreaterThan((others?.[0]?.cut ?? Infinity) - 1);
  });

  test("and the search decides for it", () => {
    const { steps, residue, judged } = planOf(forged("shaft", 2));
    const cycles = steps.flatMap(({ tried: { action } }) => (action.kind === "roughOutside" ? action.cycle : []));
    expect({ cycles, residue, verdict: judged.verdict }).toEqual({ cycles: [ALONG], residue: [], verdict: "proved" });
  });
});

test.each(PART_NAMES)("%s from its bar is not", (name) => {
  expect(waysIn(fromBar(name)).map(({ cycle }) => cycle)).not.toContain(ALONG);
});
