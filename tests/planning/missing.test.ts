import { describe, expect, test } from "vitest";
import { LEAST_REGION } from "../../src/planning/open-regions.ts";
import type { PlanRequest } from "../../src/planning/types.ts";
import type { Residue, WorkingPlan } from "../../src/planning/working-plan.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { MISSING_PARTS } from "./missing-parts.ts";
import { withMissing } from "./missing-tool.ts";
import { partOfTrade } from "./parts.ts";
import { planOf, requestOf, unprepared } from "./plan-laws.ts";

/** What a plan leaves for want of a tool. */
const wanting = ({ residue }: WorkingPlan): readonly Residue[] => residue.filter(({ missing }) => missing !== null);

/** A part with the built-in turning tools and the usual drills, without some; no other usual tool. */
function requestWithout(name: string, without: readonly number[]): PlanRequest {
  const own = Object.entries(MISSING_PARTS).find(([what]) => what === name);
  const request = requestOf(own ? own[1] : partOfTrade(name));
  if (!request) throw new Error(name);
  const tools = shippedTools.filter(({ T }) => !without.includes(T));
  return { ...request, shop: { ...request.shop, tools }, usualTools: [], partsOff: false };
}

const area = (residues: readonly Residue[], { box }: NonNullable<Residue["region"]>): number =>
  residues
    .filter(({ region }) => region && region.box.left < box.right && region.box.right > box.left)
    .filter(({ region }) => region && region.box.low < box.high && region.box.high > box.low)
    .reduce((sum, { region }) => sum + (region?.area ?? 0), 0);

/** A part, tools that are taken from the table, and what is said of those that are missing. */
const ROWS = [
  ["countersink of a bore", [], { form: "boring", mostDiameter: 12 }],
  ["face-groove", [8], { form: "recessing", site: "face" }],
  ["thread in a bore", [], { form: "boring", mostDiameter: 17.5 }, { form: "thread", thread: "M20x1.5" }],
  ["cone-pin", [1, 2, 3, 4, 7, 15], { form: "turning", hand: "right" }],
  ["thread in front of a shallow relief", [12], { form: "thread", thread: "M16" }],
  // A blade as wide as the floor, not an insert whose point is as slender as the groove.
  ["pulley", [9, 10], { form: "recessing", mostWidth: 2.2, leastDepth: 11 }],
  ["narrow groove in a face", [], { form: "recessing", site: "face", mostWidth: 2.4 }],
  ["rounded groove in a bore", [], { form: "recessing", site: "inside", mostWidth: 1, mostNose: 0.2 }],
  ["deep bore of small diameter", [], { form: "boring", mostDiameter: 5.8, leastReach: 51 }],
  ["undercut F behind a shoulder", [], { form: "turning", leastEdge: 98, descends: 15 }],
  ["valley with a steep rear flank", [4, 9, 10, 11], { form: "turning", rises: 80.5, descends: 45 }],
] as const;

describe("a tool with the data that are missing takes what is left", () => {
  test.each(ROWS)("%s without %j", (name, without, ...named) => {
    const request = requestWithout(name, without);
    const before = planOf(request),
      lacking = wanting(before);
    for (const tool of named)
      expect(lacking.map(({ missing }) => missing)).toContainEqual(expect.objectContaining(tool));
    const made = lacking.reduce((all, { missing }, i) => (missing ? withMissing(all, missing, 900 + i) : all), request);
    const after = planOf(made);
    expect([after.judged.verdict, unprepared(before), unprepared(after)]).toEqual(["proved", [], []]);
    for (const { region, missing } of lacking) {
      const left = wanting(after);
      if (region) expect([missing, area(left, region) < LEAST_REGION]).toEqual([missing, true]);
      else expect(left.filter((l) => l.missing?.thread === missing?.thread)).toEqual([]);
    }
  });
});
