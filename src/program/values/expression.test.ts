import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { readExpression } from "./expression.ts";

const known = { Q5: 12.5, QL1: -3, Q12: 0 };
const value = (text: string) => {
  const read = readExpression(text, known);
  return read.kind === "number" ? read.value : read.kind;
};

describe("readExpression", () => {
  test.each([
    ["75", 75],
    ["+75", 75],
    ["-55", -55],
    ["0.5", 0.5],
    ["0,5", 0.5],
    [".5", 0.5],
    [",5", 0.5],
    ["5.", 5],
    [" 12 ", 12],
    ["−7", -7],
    ["75/2+1", 38.5],
    ["1+2*3", 7],
    ["(1+2)*3", 9],
    ["10-4-3", 3],
    ["100/10/5", 2],
    ["-(2+3)", -5],
    ["2*-3", -6],
    ["1,5+1.5", 3],
    ["2×3", 6],
    ["9÷3", 3],
    ["Q5", 12.5],
    ["q5", 12.5],
    ["+Q5", 12.5],
    ["-Q5", -12.5],
    ["QL1*2", -6],
    ["Q5/2+1", 7.25],
    ["0*-1", 0],
    ["40-0.2", 39.8],
    ["10+4/2", 12],
    ["8/-2", -4],
  ])("%s is %d", (text, expected) => expect(value(text)).toBe(expected));

  test.each([
    ["", "empty"],
    ["   ", "empty"],
    ["abc", "notANumber"],
    ["1.2.3", "notANumber"],
    ["1,2,3", "notANumber"],
    ["-", "notANumber"],
    ["1e3", "notANumber"],
    ["5 5", "notANumber"],
    ["0x10", "notANumber"],
    ["40 h6", "notANumber"],
    ["40±0.1", "notANumber"],
    ["30 +0.02/-0.01", "badExpression"],
    ["30-0,1/-0,3", "badExpression"],
    ["NaN", "notANumber"],
    ["Infinity", "notANumber"],
    ["75/", "badExpression"],
    ["75/0", "badExpression"],
    ["(1+2", "badExpression"],
    ["1+2)", "badExpression"],
    ["()", "badExpression"],
    ["1+*2", "badExpression"],
    ["Q9", "unknownParameter"],
    ["Q5+Q9", "unknownParameter"],
    ["Q5/Q12", "badExpression"],
    ["alert(1)", "notANumber"],
  ])("%j is %s", (text, kind) => expect(value(text)).toBe(kind));

  test("an inherited property is no Q parameter's value", () => {
    expect(readExpression("Q1", Object.create({ Q1: 4 }) as Record<string, number>).kind).toBe("unknownParameter");
  });

  const any = fc.oneof(
    fc.string({ maxLength: 300 }),
    fc.string({ unit: fc.constantFrom(..."0123456789.,+-*/()Q L".split("")), maxLength: 300 }),
  );

  test("law: never throws, and every number is finite", () => {
    fc.assert(
      fc.property(any, (text) => {
        const read = readExpression(text, known);
        return read.kind !== "number" || (Number.isFinite(read.value) && !Object.is(read.value, -0));
      }),
      { numRuns: 2000 },
    );
  });

  test("law: a written number is read back, with point or comma", () => {
    fc.assert(
      fc.property(fc.integer({ min: -99_999_999, max: 99_999_999 }), (thousandths) => {
        const number = thousandths / 1000;
        return value(String(number)) === number && value(String(number).replace(".", ",")) === number;
      }),
      { numRuns: 2000 },
    );
  });

  test("law: brackets and order agree with arithmetic", () => {
    const whole = fc.integer({ min: -999, max: 999 });
    fc.assert(
      fc.property(
        whole,
        whole,
        whole,
        (a, b, c) =>
          value(`${a}+${b}*${c}`) === a + b * c + 0 &&
          value(`(${a}+${b})*${c}`) === (a + b) * c + 0 &&
          value(`${a}-${b}-${c}`) === a - b - c + 0,
      ),
      { numRuns: 2000 },
    );
  });

  test("law: a sum one sign too long is refused, not read in part", () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 0, max: 9999 }),
        fc.constantFrom("+", "-", "*", "/"),
        (n, sign) => value(`${n}${sign}`) === "badExpression",
      ),
    );
  });
});
