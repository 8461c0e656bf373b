import { describe, expect, test } from "vitest";
import { LANGUAGES } from "../src/i18n/languages.ts";
import { loadTexts, type PartName } from "../src/i18n/parts.ts";
import { code, sources } from "./sources.ts";

const names = sources("src/i18n/en")
  .flatMap(({ path }) => /^src\/i18n\/en\/([\w-]+)\.ts$/.exec(path)?.[1] ?? [])
  .filter((name) => name !== "parts") as readonly PartName[];

/** The shape of texts, by their keys. The length of a list depends on the language. */
function shapeOf(texts: unknown): unknown {
  if (typeof texts !== "object" || texts === null) return typeof texts;
  if (Array.isArray(texts)) return "list";
  return Object.fromEntries(
    Object.entries(texts)
      .map(([key, inner]: [string, unknown]) => [key, shapeOf(inner)])
      .sort(),
  );
}

/** Parts with keys that some languages lack: terms of the glossary, common mistakes with a few parameters. */
const OWN: ReadonlySet<PartName> = new Set(["glossary", "mistakes"]);

describe.each(LANGUAGES.filter((language) => language !== "en"))("the texts in %s", (language) => {
  test.each(names)("say in %s what the English ones say", async (name) => {
    const [english, own] = [await loadTexts("en", name), await loadTexts(language, name)];
    if (OWN.has(name)) expect(Object.keys(own).sort()).toEqual(Object.keys(english).sort());
    else expect(shapeOf(own)).toEqual(shapeOf(english));
  });
});

/**
 * A new screen language is its folder and its line; languages of NC text and of lessons are listed next to it. What links
 * are packed with never changes, or old links could not be read.
 */
test("no screen language is named outside its folder and the list of languages", () => {
  const named = /["'/](?:de|fr|zh)["'/]|^\s*(?:de|fr|zh):|[{,] ?(?:de|fr|zh)\b ?[,:}]/;
  const may = /^src\/(?:i18n\/(?:languages\.ts|nc-labels\.ts|\w\w\/|nc\/)|nc\/nc-languages\.ts)|-dictionary\.ts$/;
  const all = [...sources("src"), ...sources("scripts"), ...sources("e2e/pages")].filter(({ path }) => !may.test(path));
  const found = all.flatMap(({ path, text }) =>
    code(text)
      .split("\n")
      .filter((line) => named.test(line))
      .map((line) => `${path}: ${line.trim()}`),
  );
  expect(found).toEqual([]);
});
