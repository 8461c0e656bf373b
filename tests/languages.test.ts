import { describe, expect, test } from "vitest";
import { LANGUAGES } from "../src/i18n/languages.ts";
import { loadTexts, type PartName } from "../src/i18n/parts.ts";
import { code, sources } from "./sources.ts";

const names = sources("src/i18n/en")
  .flatMap(({ path }) => /^src\/i18n\/en\/([\w-]+)\.ts$/.exec(path)?.[1] ?? [])
  .filter((name) => name !== "parts") as readonly PartName[];

/** What texts are made of, by their keys. How many items a list has is a matter of the language. */
function shapeOf(texts: unknown): unknown {
  if (typeof texts !== "object" || texts === null) return typeof texts;
  if (Array.isArray(texts)) return "list";
  return Object.fromEntries(
    Object.entries(texts)
      .map(([key, inner]: [string, unknown]) => [key, shapeOf(inner)])
      .sort(),
  );
}

/** What a term of the glossary has in some languages only, and what is often done wrong with a few parameters. */
const OWN: ReadonlySet<PartName> = new Set(["glossary", "mistakes"]);

describe.each(LANGUAGES.filter((language) => language !== "en"))("the texts in %s", (language) => {
  test.each(names)("say in %s what the English ones say", async (name) => {
    const [english, own] = [await loadTexts("en", name), await loadTexts(language, name)];
    if (OWN.has(name)) expect(Object.keys(own).sort()).toEqual(Object.keys(english).sort());
    else expect(shapeOf(own)).toEqual(shapeOf(english));
  });
});

/**
 * A new language of the screen is its folder and its line; what is said in languages of NC text and of lessons stands
 * beside it.
 */
test("no screen language is named outside its folder and the list of languages", () => {
  const named = /["'/](?:de|fr|zh)["'/]|^\s*(?:de|fr|zh):|[{,] ?(?:de|fr|zh)\b ?[,:}]/;
  const may = /^src\/(?:i18n\/(?:languages\.ts|nc-labels\.ts|\w\w\/|nc\/)|nc\/nc-languages\.ts)/;
  const all = [...sources("src"), ...sources("scripts"), ...sources("e2e/pages")].filter(({ path }) => !may.test(path));
  const found = all.flatMap(({ path, text }) =>
    code(text)
      .split("\n")
      .filter((line) => named.test(line))
      .map((line) => `${path}: ${line.trim()}`),
  );
  expect(found).toEqual([]);
});
