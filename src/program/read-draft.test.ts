import { describe, expect, test } from "vitest";
import { catalogue } from "../cycles/index.ts";
import { angle, axialParam, choice, diameterParam, feedParam, lengthParam, radial } from "../cycles/params.ts";
import { readText } from "./field.ts";
import { exampleDraft, promptField, readDraft } from "./read-draft.ts";

const infeed = radial("infeedRadial", [0.001, 999.999], 3);
const feed = feedParam("roughingFeed", [0, 99999.999], 0.3);
const diameter = diameterParam("startDiameter", [-99999.999, 99999.999], 75);
const lean = angle("surfaceAngle", [0, 89.9999], 5);
const kind = choice("operation", [0, 1, 2, 3], 0);
const corner = lengthParam("cornerRadius", [0, 999.999], 1.5, { optional: true });

describe("readText", () => {
  test("missing: empty is missing and never 0", () => {
    expect(readText(promptField("Q491", diameter), "  ")).toMatchObject({ value: null, empty: true, issue: { code: "missing", at: "Q491", severity: "error" } });
    expect(readText(promptField("Q491", diameter), "0")).toMatchObject({ value: 0, empty: false, issue: null });
  });

  test("an optional field may stay empty and is then 0", () => {
    expect(readText(promptField("Q500", corner), "")).toMatchObject({ value: null, empty: true, issue: null });
    expect(readDraft({ params: { Q500: corner } }, {}).values).toEqual({ Q500: 0 });
    expect(readText(promptField("Q500", corner), "x")).toMatchObject({ value: null, issue: { code: "notANumber", data: { text: "x" } } });
  });

  test("notANumber", () => {
    expect(readText(promptField("Q491", diameter), "seventy").issue).toMatchObject({ code: "notANumber", data: { text: "seventy" } });
    expect(readText(promptField("Q491", diameter), "70").issue).toBeNull();
  });

  test("badExpression", () => {
    expect(readText(promptField("Q491", diameter), "75/").issue).toMatchObject({ code: "badExpression", data: { text: "75/" } });
    expect(readText(promptField("Q491", diameter), "75/2+1")).toMatchObject({ value: 38.5, computed: true, issue: null });
  });

  test("unknownParameter", () => {
    expect(readText(promptField("Q491", diameter), "Q7").issue).toMatchObject({ code: "unknownParameter", data: { name: "Q7" } });
    expect(readText(promptField("Q491", diameter), "Q7", { Q7: 60 })).toMatchObject({ value: 60, written: { parameter: "Q7", negative: false }, issue: null });
  });

  test.each([
    ["0", 0.001], ["-5", 0.001], ["0.0004", 0.001], ["1000", 999.999],
  ])("outOfRange: %s of 0.001 to 999.999, the nearest is %d", (typed, nearest) => {
    expect(readText(promptField("Q463", infeed), typed).issue).toMatchObject({ code: "outOfRange", data: { min: 0.001, max: 999.999, nearest } });
  });
  test.each(["0.001", "999.999", "3", "999.9994"])("%s lies in 0.001 to 999.999", (typed) => {
    expect(readText(promptField("Q463", infeed), typed).issue).toBeNull();
  });

  test("notAChoice names the nearest one", () => {
    expect(readText(promptField("Q215", kind), "7").issue).toMatchObject({ code: "notAChoice", data: { value: 7, choices: [0, 1, 2, 3], nearest: 3 } });
    expect(readText(promptField("Q215", kind), "1.4").issue).toMatchObject({ code: "notAChoice", data: { nearest: 1 } });
    expect(readText(promptField("Q215", kind), "2")).toMatchObject({ value: 2, issue: null });
  });

  test.each(["FAUTO", "fauto", "auto", " F AUTO "])("a feed may be %s", (typed) => {
    expect(readText(promptField("Q478", feed), typed)).toMatchObject({ value: null, written: "auto", issue: null });
  });
  test("only a feed may be FAUTO", () => {
    expect(readText(promptField("Q491", diameter), "FAUTO").issue).toMatchObject({ code: "notANumber" });
  });

  test("values are rounded to what the control keeps", () => {
    expect(readText(promptField("Q491", diameter), "10/3").value).toBe(3.333);
    expect(readText(promptField("Q495", lean), "10/3").value).toBe(3.3333);
    expect(readText(promptField("Q492", axialParam("startZ", [-9, 9], 0)), "-0.0001")).toMatchObject({ value: 0 });
    expect(Object.is(readText(promptField("Q492", axialParam("startZ", [-9, 9], 0)), "-0.0001").value, -0)).toBe(false);
  });
});

describe.each(catalogue.map((cycle) => [cycle.number, cycle] as const))("readDraft of cycle %i", (_, cycle) => {
  test("takes the printed example as it is", () => {
    const read = readDraft(cycle, exampleDraft(cycle));
    expect(read.issues).toEqual([]);
    expect(read.values).toEqual(Object.fromEntries(Object.entries(cycle.params).map(([q, p]) => [q, p.example])));
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
