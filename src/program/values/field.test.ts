import { describe, expect, test } from "vitest";
import { angle, axialParam, choice, diameterParam, feedParam, lengthParam, radial } from "../../cycles/params.ts";
import { anyNumber, checkNumber, type Field, readText, sumOf } from "./field.ts";
import { promptField } from "../job/read-draft.ts";

const infeed = radial("infeedRadial", [0.001, 999.999], 3);
const feed = feedParam("roughingFeed", [0, 99999.999], 0.3);
const diameter = diameterParam("startDiameter", [-99999.999, 99999.999], 75);
const lean = angle("surfaceAngle", [0, 89.9999], 5);
const kind = choice("operation", [0, 1, 2, 3], 0);
const corner = lengthParam("cornerRadius", [0, 999.999], 1.5, { optional: true });

describe("readText", () => {
  test("missing: empty is missing and never 0", () => {
    expect(readText(promptField("Q491", diameter), "  ")).toMatchObject({
      value: null,
      empty: true,
      issue: { code: "missing", at: "Q491", severity: "error" },
    });
    expect(readText(promptField("Q491", diameter), "0")).toMatchObject({ value: 0, empty: false, issue: null });
  });

  test("an optional field may stay empty, and is not 0", () => {
    expect(readText(promptField("Q500", corner), "")).toMatchObject({ value: null, empty: true, issue: null });
    expect(readText(promptField("Q500", corner), "x")).toMatchObject({
      value: null,
      issue: { code: "notANumber", data: { text: "x" } },
    });
  });

  test("notANumber", () => {
    expect(readText(promptField("Q491", diameter), "seventy").issue).toMatchObject({
      code: "notANumber",
      data: { text: "seventy" },
    });
    expect(readText(promptField("Q491", diameter), "70").issue).toBeNull();
  });

  test("badExpression", () => {
    expect(readText(promptField("Q491", diameter), "75/").issue).toMatchObject({
      code: "badExpression",
      data: { text: "75/" },
    });
    expect(readText(promptField("Q491", diameter), "75/2+1")).toMatchObject({
      value: 38.5,
      computed: true,
      issue: null,
    });
  });

  test("unknownParameter", () => {
    expect(readText(promptField("Q491", diameter), "Q7").issue).toMatchObject({
      code: "unknownParameter",
      data: { name: "Q7" },
    });
    expect(readText(promptField("Q491", diameter), "Q7", { Q7: 60 })).toMatchObject({
      value: 60,
      written: { parameter: "Q7", negative: false },
      issue: null,
    });
  });

  test.each([
    ["0", 0.001],
    ["-5", 0.001],
    ["0.0004", 0.001],
    ["1000", 999.999],
  ])("outOfRange: %s of 0.001 to 999.999, the nearest is %d", (typed, nearest) => {
    expect(readText(promptField("Q463", infeed), typed).issue).toMatchObject({
      code: "outOfRange",
      data: { min: 0.001, max: 999.999, nearest },
    });
  });
  test.each(["0.001", "999.999", "3", "999.9994"])("%s lies in 0.001 to 999.999", (typed) => {
    expect(readText(promptField("Q463", infeed), typed).issue).toBeNull();
  });

  test("notAChoice names the nearest one", () => {
    expect(readText(promptField("Q215", kind), "7").issue).toMatchObject({
      code: "notAChoice",
      data: { value: 7, choices: [0, 1, 2, 3], nearest: 3 },
    });
    expect(readText(promptField("Q215", kind), "1.4").issue).toMatchObject({
      code: "notAChoice",
      data: { nearest: 1 },
    });
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

describe("a word of a block", () => {
  const word: Field = { ...anyNumber, id: "X", kind: "length", increments: true, optional: false };
  const feedOfBlock: Field = { ...anyNumber, id: "F", kind: "feed", rapid: true };

  test.each([
    ["I-5", -5, true],
    ["i2,5", 2.5, true],
    ["7", 7, false],
  ])("%s is %d, incremental: %s", (typed, value, incremental) => {
    expect(readText(word, typed)).toMatchObject({ value, incremental, issue: null });
  });
  test("an I alone is no number, and none belongs where nothing is incremental", () => {
    expect(readText(word, "I").issue?.code).toBe("notANumber");
    expect(readText({ ...word, increments: false }, "I5").issue?.code).toBe("notANumber");
  });

  test("FMAX is a feed where the field says so", () => {
    expect(readText(feedOfBlock, "fmax")).toMatchObject({ written: "max", issue: null });
    expect(readText({ ...feedOfBlock, rapid: false }, "FMAX").issue?.code).toBe("notANumber");
  });

  test("a parameter without a value is still what the block says", () => {
    expect(readText(word, "−q7")).toMatchObject({
      value: null,
      written: { parameter: "Q7", negative: true },
      issue: { code: "unknownParameter" },
    });
    expect(readText(word, "QS7")).toMatchObject({ value: null, written: { parameter: "QS7", negative: false } });
    expect(readText(word, "Q7+1")).toMatchObject({ value: null, written: null });
  });
});

describe("checkNumber", () => {
  test("what is no number lies in no range", () => {
    expect(checkNumber({ id: "R", range: [0, 5] }, NaN)?.code).toBe("outOfRange");
    expect(checkNumber({ id: "R", range: [0, 5] }, Infinity)?.data).toMatchObject({ nearest: 5 });
    expect(checkNumber({ id: "R", range: [0, 5] }, 5)).toBeNull();
  });
  test("a count is whole", () => {
    expect(checkNumber({ id: "Q475", kind: "count", range: [1, 500] }, 2.4)).toMatchObject({
      code: "notWhole",
      data: { nearest: 2 },
    });
    expect(checkNumber({ id: "Q475", kind: "count", range: [1, 500] }, 0.4)).toMatchObject({
      code: "outOfRange",
      data: { nearest: 1 },
    });
    expect(checkNumber({ id: "Q475", kind: "count", range: [1, 500] }, 3)).toBeNull();
    expect(readText({ ...anyNumber, kind: "count", range: [1, 500], decimals: 3 }, "1,5").issue?.code).toBe("notWhole");
  });
});

test.each([
  ["75/2", "37.5"],
  ["10/3", "3.333333"],
  ["75", null],
  ["75/", null],
  ["", null],
])("leaving a field, %j becomes %j", (typed, sum) => {
  expect(sumOf(typed)).toBe(sum);
});
