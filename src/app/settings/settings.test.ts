import { expect, test } from "vitest";
import { readSettings } from "./settings.ts";

test("settings survive, and what does not fit keeps its first value", () => {
  const first = readSettings(null);
  expect(readSettings(JSON.stringify({ ...first, language: "fr", theme: "dark", xDown: true }))).toEqual({
    ...first,
    language: "fr",
    theme: "dark",
    xDown: true,
  });
  expect(readSettings(JSON.stringify({ language: "xx", theme: 3, programFolded: "yes", other: 1 }))).toEqual(first);
});

test.each(["", "{", "null", "[]", "7"])("damaged settings %j are the first ones",
  (text) => expect(readSettings(text)).toEqual(readSettings(null)));
