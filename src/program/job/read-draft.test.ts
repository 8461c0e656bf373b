import { describe, expect, test } from "vitest";
import { cuttingCycles, cycleByNumber } from "../../cycles/index.ts";
import { lengthParam } from "../../cycles/params.ts";
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

  test("an empty draft misses every parameter that is neither optional nor reserved, in order", () => {
    const read = readDraft(cycle, {});
    const needed = Object.entries(cycle.params)
      .filter(([, p]) => !p.optional && !p.reserved)
      .map(([q]) => q);
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

describe("a parameter without effect", () => {
  const cycle = cycleByNumber(812) as NonNullable<ReturnType<typeof cycleByNumber>>;
  const draft = { ...exampleDraft(cycle), Q501: "0", Q502: "", Q504: "0.37" };

  test("may be left out, and counts as 0 then", () => {
    const { issues, values } = readDraft(cycle, draft);
    expect(issues).toEqual([]);
    expect(values).toMatchObject({ Q501: 0, Q502: 0, Q503: 1, Q504: 0.37 });
  });
  test.each([
    ["there is one", "2"],
    ["nothing is typed there", ""],
    ["what is typed there is none", "5"],
    ["it cannot be read", "?"],
  ])("is required where %s", (_, Q501) => {
    const { perField, values } = readDraft(cycle, { ...draft, Q501 });
    expect(perField["Q502"]?.issue).toMatchObject({ code: "missing", at: "Q502" });
    expect(values).toBeNull();
  });
  test("is kept where it is typed, and still has to be a number", () => {
    expect(readDraft(cycle, { ...draft, Q502: "1.23" }).values).toMatchObject({ Q502: 1.23 });
    expect(readDraft(cycle, { ...draft, Q502: "1.2.3" }).issues.map((i) => i.code)).toEqual(["notANumber"]);
  });
  test("goes by a Q parameter whose value is known", () => {
    expect(readDraft(cycle, { ...draft, Q501: "Q5" }).perField["Q502"]?.issue).not.toBeNull();
    expect(readDraft(cycle, { ...draft, Q501: "Q5" }, { Q5: 0 }).issues).toEqual([]);
  });
});
