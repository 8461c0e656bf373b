import { expect, test } from "vitest";
import { PART_NAMES, partOfTrade, PEER_NAMES } from "./parts.ts";
import { planOf, requestOf, unprepared } from "./plan-laws.ts";

/**
 * Planned in `plans.test.ts` and `missing.test.ts`, or longer to plan than all others: `npm run laws -- --trade` looks at
 * these as well.
 */
const ELSEWHERE = ["bolt", "dowel", "flange", "spacer", "spool", "thin-shaft", "pulley", "cone-pin", "face-groove"];
const LONG = ["hollow-shaft", "nozzle", "ball-pin", "bush", "piston", "sleeve"];

test.each([...PART_NAMES, ...PEER_NAMES].filter((name) => ![...ELSEWHERE, ...LONG].includes(name)))(
  "each step of the plan of the %s is prepared by those before it",
  (name) => {
    const request = requestOf(partOfTrade(name));
    expect(request && unprepared(planOf(request))).toEqual([]);
  },
);
