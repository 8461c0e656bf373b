import { describe, expect, test } from "vitest";
import { areaOf } from "../../src/kernel/area/area.ts";
import { missesBlank } from "../../src/kernel/area/clamping.ts";
import { printPart, readPart } from "../../src/planning/part/part-file.ts";
import { plannedPart } from "../../src/planning/part/planned-part.ts";
import { projectFile } from "../sources.ts";
import { PART_NAMES, partOfTrade, PEER_NAMES } from "./parts.ts";

test("the example of the documentation is a part", () => {
  const [, example = ""] = /```json\n([^]*?)```/.exec(projectFile("docs/planning.md")) ?? [];
  const { part } = readPart(example);
  expect(part && plannedPart(part).problems).toEqual([]);
});

/** Room for parting off between the part and the chuck, mm. */
const PARTING = 5;

describe("parts of the trade", () => {
  test.each([...PART_NAMES, ...PEER_NAMES])("%s is a part within its blank", (name) => {
    const { part, blank, problems } = plannedPart(partOfTrade(name));
    expect(problems).toEqual([]);
    expect(areaOf(part?.rings ?? [])).toBeGreaterThan(50);
    expect(areaOf(blank)).toBeGreaterThan(areaOf(part?.rings ?? []));
  });

  test.each(PART_NAMES)("%s is held by its blank, with room behind it", (name) => {
    const finished = partOfTrade(name),
      { part, blank, clamping } = plannedPart(finished);
    if (!part || !clamping) throw new Error(name);
    expect(missesBlank(clamping.clamping, blank)).toBe(false);
    const end = part.outside.segments.at(-1)?.to.z ?? 0,
      room = finished.partsOff ? PARTING : 0;
    const isTurnedRound = !finished.partsOff && !finished.unmachinedBehind;
    if (!isTurnedRound) expect(end - clamping.clamping.face).toBeGreaterThanOrEqual(room);
  });

  test.each([...PART_NAMES, ...PEER_NAMES])("%s is the same when it is printed and read", (name) => {
    const part = partOfTrade(name);
    expect(readPart(printPart(part))).toEqual({ part, problems: [] });
  });
});
