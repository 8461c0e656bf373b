import { describe, expect, test } from "vitest";
import { LEAST_REGION } from "../../src/planning/open-regions.ts";
import type { PlanRequest } from "../../src/planning/types.ts";
import type { Residue, WorkingPlan } from "../../src/planning/working-plan.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { withMissing } from "./missing-tool.ts";
import { partOfTrade } from "./parts.ts";
import { planOf, requestOf } from "./plan-laws.ts";

/** What a plan leaves for want of a tool. */
const wanting = ({ residue }: WorkingPlan): readonly Residue[] => residue.filter(({ missing }) => missing !== null);

/** A part with the built-in turning tools and the usual drills, without some; no other usual tool. */
function requestWithout(name: string, without: readonly number[]): PlanRequest {
  const request = requestOf(partOfTrade(name));
  if (!request) throw new Error(name);
  const tools = shippedTools.filter(({ T }) => !without.includes(T));
  return { ...request, shop: { ...request.shop, tools }, usualTools: [], partsOff: false };
}

const area = (residues: readonly Residue[], { box }: NonNullable<Residue["region"]>): number =>
  residues
    .filter(({ region }) => region && region.box.left < box.right && region.box.right > box.left)
    .filter(({ region }) => region && region.box.low < box.high && region.box.high > box.low)
    .reduce((sum, { region }) => sum + (region?.area ?? 0), 0);

/** The first data that are missing for each form, and whether a tool with them makes the region. */
describe("a tool with the data that are missing takes what is left", () => {
  test.each([
    ["bush", []],
    ["piston", []],
    ["face-groove", [8]],
    ["sleeve", []],
    ["cone-pin", [1, 2, 3, 4, 7, 15]],
    ["bolt", [12]],
  ] as const)("%s without %j", (name, without) => {
    const request = requestWithout(name, without);
    const lacking = wanting(planOf(request));
    expect(lacking.length).toBeGreaterThan(0);
    const made = lacking.reduce((all, { missing }, i) => (missing ? withMissing(all, missing, 900 + i) : all), request);
    const after = planOf(made);
    expect(after.judged.verdict).toBe("proved");
    for (const { region, missing } of lacking) {
      const left = wanting(after);
      if (region) expect([missing, area(left, region) < LEAST_REGION]).toEqual([missing, true]);
      else expect(left.filter((l) => l.missing?.thread === missing?.thread)).toEqual([]);
    }
  });
});
