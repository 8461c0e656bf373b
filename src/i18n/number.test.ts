import { expect, test } from "vitest";
import { inScreenWriting, numbersInScreenWriting } from "./number.ts";

test("a typed number has the decimal sign of the screen; sums, parameters and words stay as they are", () => {
  expect(["90.5", "-.5", "+2.", "7"].map((text) => inScreenWriting("de", text))).toEqual(["90,5", "-,5", "+2,", "7"]);
  expect(inScreenWriting("en", "90.5")).toBe("90.5");
  for (const text of ["Q5 + 0.1", "A.h", "Q5", ""]) expect(inScreenWriting("fr", text)).toBe(text);
});

test("the numbers in a value of several words, too", () => {
  expect(numbersInScreenWriting("fr", "Q491 50.5, Q493 75")).toBe("Q491 50,5, Q493 75");
  expect(numbersInScreenWriting("zh", "Z-12.5")).toBe("Z-12.5");
});
