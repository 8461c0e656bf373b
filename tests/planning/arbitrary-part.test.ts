import * as fc from "fast-check";
import { expect, test } from "vitest";
import "../seed.ts";
import { areaOf } from "../../src/kernel/area/area.ts";
import { plannedPart } from "../../src/planning/part/planned-part.ts";
import { arbitraryParts } from "./arbitrary-part.ts";

test("random parts are parts, with a mark for each element", () => {
  const seen = new Set<string>();
  fc.assert(
    fc.property(arbitraryParts, ({ part: finished, features }) => {
      const { part, blank, problems } = plannedPart(finished);
      expect(problems).toEqual([]);
      expect(part?.outside.marks.length).toBe(part?.outside.segments.length);
      expect(areaOf(part?.rings ?? [])).toBeGreaterThan(0);
      expect(areaOf(blank)).toBeGreaterThan(areaOf(part?.rings ?? []));
      for (const each of features) seen.add(each);
    }),
    { numRuns: 150 },
  );
  expect([...seen].toSorted()).toEqual([
    "bore arc",
    "bore taper",
    "bore undercut",
    "centres",
    "chuckOutside",
    "collet",
    "concave",
    "convex",
    "face groove",
    "forged",
    "groove",
    "plain",
    "softJaws",
    "taper",
    "thread",
    "tube",
    "undercut",
    "valley",
    "wider behind",
  ]);
});
