import { expect, test } from "vitest";
import {
  erase,
  insert,
  isOnlySign,
  minuendOf,
  minus,
  subtracted,
  toggleSign,
  type EntryState,
} from "./number-entry.ts";

/** "12|" is a caret behind 12; "[12]" is 12 selected. */
function entry(picture: string): EntryState {
  const text = picture.replace(/[|[\]]/g, "");
  const caret = picture.indexOf("|");
  return caret >= 0
    ? { text, from: caret, to: caret, negative: false }
    : { text, from: picture.indexOf("["), to: picture.indexOf("]") - 1, negative: false };
}

test.each([
  ["12|", "-12"],
  ["1|2", "-12"],
  ["-12|", "12"],
  ["+12|", "-12"],
  ["3,5|", "-3,5"],
  ["|", "-"],
  ["[50]", "-50"],
  ["[-50]", "50"],
])("minus in %s gives %s", (before, after) => expect(minus(entry(before)).text).toBe(after));

test.each([
  ["75/2|", "75/2-"],
  ["Q5|", "Q5-"],
  ["(3|", "(3-"],
])("minus in the sum %s stays a minus", (before, after) => expect(minus(entry(before)).text).toBe(after));

test("the caret stays at its digit", () => expect(minus(entry("1|2"))).toMatchObject({ from: 2, to: 2 }));

test.each([
  ["[50]", "-5"],
  ["[-50]", "-5"],
])("minus, then 5, over %s begins a negative number", (before, after) =>
  expect(insert(minus(entry(before)), "5").text).toBe(after),
);

test.each([
  ["[50]", "-4"],
  ["[-55]", "4"],
])("the ± key, then 4, over %s keeps the sign that is seen", (before, after) =>
  expect(insert(toggleSign(entry(before)), "4").text).toBe(after),
);

test.each([
  ["60|", "60-2"],
  ["3,5|", "3,5-2"],
  ["-55|", "-55-2"],
  ["+60|", "+60-2"],
])("minus and a digit behind %s make a sum", (before, after) => {
  const minuend = minuendOf(entry(before));
  expect(subtracted(minus(entry(before)), minuend ?? "", "2")?.text).toBe(after);
});
test.each(["6|0", "[60]", "[-60]", "-6|0", "|", "-|", "60+3|"])("minus in %s begins no sum", (before) =>
  expect(minuendOf(entry(before))).toBeNull(),
);

test("digits replace the selection", () => expect(insert(entry("[75]"), "8").text).toBe("8"));
test("erase takes the selection, or one character", () => {
  expect(erase(entry("[75]")).text).toBe("");
  expect(erase(entry("7|5")).text).toBe("5");
  expect(erase(entry("|75")).text).toBe("75");
});

test.each([
  ["-", true],
  ["I+", true],
  ["", false],
  ["-1", false],
  ["1-", false],
])("%s is only a sign: %s", (text, only) => expect(isOnlySign(text)).toBe(only));

test.each([
  ["-1|2", "1|2"],
  ["+1|2", "-1|2"],
  ["-12|", "12|"],
  ["|-12", "|12"],
])("the sign of %s changes, and the caret stays at its digit: %s", (before, after) => {
  const { text, from, to } = toggleSign(entry(before));
  expect([`${text.slice(0, from)}|${text.slice(from)}`, to]).toEqual([after, from]);
});
