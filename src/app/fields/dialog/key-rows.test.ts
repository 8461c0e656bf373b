import { expect, test } from "vitest";
import { FIELD_ROWS, KEY_ROWS } from "./key-rows.ts";

test.each([
  ["sums", KEY_ROWS.sums, KEY_ROWS.flatSums],
  ["words of a field", FIELD_ROWS.words.high, FIELD_ROWS.words.flat],
  ["open values of a field", FIELD_ROWS.open.high, FIELD_ROWS.open.flat],
])("the flat keypad of %s has the keys of the high one, each once", (_, high, flat) => {
  expect([...flat].sort()).toEqual([...high].sort());
  expect(new Set(flat).size).toBe(flat.length);
  // Digits keep their places relative to each other.
  for (const digit of [4, 5, 6]) expect(flat.indexOf(String(digit))).toBe(flat.indexOf(String(digit + 3)) + 9);
});
