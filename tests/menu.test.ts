import { menu } from "virtual:cycle-menu";
import { describe, expect, test } from "vitest";
import { cuttingCycles } from "../src/cycles/index.ts";
import { texts } from "../src/i18n/index.ts";
import { LANGUAGES } from "../src/i18n/languages.ts";
import { menuWords } from "../src/i18n/menu-words.ts";
import { PICTOGRAM } from "../src/view/pictogram-box.ts";

test("the menu has the cycles that cut, in the order of the catalogue", () => {
  expect(menu.map(({ number, group }) => [number, group])).toEqual(
    cuttingCycles.map(({ number, group }) => [number, group]),
  );
});

test("only cycles that no page prints are marked", () => {
  expect(menu.filter(({ recalled }) => recalled).map(({ number }) => number)).toEqual(
    cuttingCycles.filter(({ manual }) => manual === null).map(({ number }) => number),
  );
});

describe.each(LANGUAGES)("the words of the menu in %s", (language) => {
  const words = menuWords(language);
  test.each(menu.map(({ number }) => number))("%i", (number) => {
    const { name, summary } = texts(language).cycles.of[number as 812];
    expect(words.of[number]).toMatchObject({ name, summary });
  });
  test("contain no text of a dialog", () =>
    expect(JSON.stringify(words)).not.toContain(texts(language).cycles.of[812].description[0]));
});

describe("drawings", () => {
  const numbers = (d: string) =>
    [...d.matchAll(/(-?[\d.]+) (-?[\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)] as const);
  test.each(menu.filter(({ group }) => group !== "special").map((cycle) => [cycle.number, cycle] as const))(
    "%i stays in its box",
    (_, cycle) => {
      expect(cycle.pictograms.length).toBeGreaterThan(0);
      for (const { body, cut, contour } of cycle.pictograms)
        for (const [x, y] of [body, cut, contour].flatMap(numbers)) {
          expect(x).toBeGreaterThanOrEqual(0);
          expect(x).toBeLessThanOrEqual(PICTOGRAM.width);
          expect(y).toBeGreaterThanOrEqual(0);
          expect(y).toBeLessThanOrEqual(PICTOGRAM.height);
        }
    },
  );

  test("inside and outside of a cycle have different drawings", () => {
    const twice = menu.filter(({ pictograms }) => pictograms.length === 2);
    expect(twice.length).toBeGreaterThan(0);
    for (const {
      pictograms: [outside, inside],
    } of twice)
      expect(inside?.body).not.toBe(outside?.body);
  });
});
