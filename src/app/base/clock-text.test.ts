import { expect, test } from "vitest";
import { page } from "../../i18n/en/first/page.ts";
import { durationText } from "./clock-text.ts";

test.each([
  [0, "0.0 s"],
  [28.64, "28.6 s"],
  [59.49, "59.5 s"],
  [59.96, "1 min 0 s"],
  [170.4, "2 min 50 s"],
  [3599.7, "1 h 0 min"],
  [42_340, "11 h 45 min"],
])("%d seconds", (seconds, text) => {
  expect(durationText(page.effect.duration, "en", seconds)).toBe(text);
});
