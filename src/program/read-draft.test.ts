import { describe, expect, test } from "vitest";
import { cuttingCycles } from "../cycles/index.ts";
import { lengthParam } from "../cycles/params.ts";
import { exampleDraft, readDraft } from "./read-draft.ts";

test("a prompt that may be left out then counts as 0", () => {
  const Q500 = lengthParam("cornerRadius", [0, 999.999], 1.5, { optional: true });
  expect(readDraft({ params: { Q500 } }, {}).values).toEqual({ Q500: 0 });
});

describe.each(cuttingCycles.map((cycle) => [cycle.number, cycle] as const))("readDraft of cycle %i", (_, cycle) => {
  test("takes the printed example as it is", () => {
    const read = readDraft(cycle, exampleDraft(cycle));
    expect(read.issues).toEqual([]);
    const listed = Object.fromEntries(Object.entries(cycle.params).map(([q, p]) => [q, p.example]));
    expect(read.values).toEqual({ ...listed, ...cycle.setup?.values });
  });

  test("an empty draft misses every parameter that is not optional, in order", () => {
    const read = readDraft(cycle, {});
    const needed = Object.entries(cycle.params).filter(([, p]) => !p.optional).map(([q]) => q);
    expect(read.values).toBeNull();
    expect(read.issues.map((i) => [i.code, i.at])).toEqual(needed.map((q) => ["missing", q]));
  });

  test("one bad field keeps the others", () => {
    const q = Object.keys(cycle.params)[1] ?? "";
    const read = readDraft(cycle, { ...exampleDraft(cycle), [q]: "?" });
    expect(read.values).toBeNull();
    expect(Object.keys(read.partial)).toHaveLength(Object.keys(cycle.params).length - 1);
    expect(read.perField[q]?.issue).toMatchObject({ code: "notANumber", at: q });
  });
});
