import { expect, test } from "vitest";
import { PART_NAMES, partOfTrade, PEER_NAMES } from "./parts.ts";
import { planOf, requestOf, unprepared } from "./plan-laws.ts";

test.each([...PART_NAMES, ...PEER_NAMES])("each step of the plan of the %s is prepared by those before it", (name) => {
  const request = requestOf(partOfTrade(name));
  expect(request && unprepared(planOf(request))).toEqual([]);
});
