import * as fc from "fast-check";
import { readdirSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { printWords } from "../src/features/course/drawing/print-words.ts";
import { drawnTask, type DrawnTask } from "../src/course/drawn-task.ts";
import { taskSchema } from "../src/course/task.ts";
import { courseDrawing as english } from "../src/i18n/en/course-drawing.ts";
import { courseDrawing as german } from "../src/i18n/de/course-drawing.ts";
import { courseDrawing as french } from "../src/i18n/fr/course-drawing.ts";
import { courseDrawing as chinese } from "../src/i18n/zh/course-drawing.ts";
import { forMaker } from "../src/view/drawing/maker.ts";
import { drawingOnSheet, partDrawing } from "../src/view/drawing/part-drawing.ts";
import { faultsOf } from "./drawing-faults.ts";
import { partOf, turnedParts } from "./drawn-parts.ts";
import { projectFile } from "./sources.ts";

const LANGUAGES = {
  en: printWords(english, "en"),
  de: printWords(german, "de"),
  fr: printWords(french, "fr"),
  zh: printWords(chinese, "zh"),
};
const SHEET = { width: 275, height: 158 };
const ROOMS = [
  { width: 178, height: 128 },
  { width: 84, height: 128 },
];

const drawings = readdirSync("src/course/tasks").flatMap((file): (readonly [string, DrawnTask])[] => {
  const drawn = drawnTask(taskSchema.parse(JSON.parse(projectFile(`src/course/tasks/${file}`))));
  return drawn ? [[file, drawn]] : [];
});

describe.each(drawings)("%s", (_, drawn) => {
  test.each(Object.entries(LANGUAGES))("is a legible print, %s", (_language, words) => {
    const prints = [
      ...ROOMS.map((room) => partDrawing(forMaker(drawn, words), room)),
      drawingOnSheet(forMaker(drawn, words), SHEET),
    ];
    expect(prints.map((print) => print && faultsOf(print))).toEqual(prints.map(() => []));
  });
  test("has room on one sheet", () => {
    const print = drawingOnSheet(forMaker(drawn, LANGUAGES.de), SHEET);
    expect(print?.width).toBeLessThanOrEqual(SHEET.width);
    expect(print?.height).toBeLessThanOrEqual(SHEET.height);
  });
});

/** A stepped shaft with broken edges and a stepped bore, in tenths of a millimetre. */
const turned = fc.record({
  steps: fc.array(
    fc.record({
      rise: fc.integer({ min: 13, max: 170 }),
      long: fc.integer({ min: 31, max: 290 }),
      corner: fc.integer({ min: 0, max: 12 }),
      deviation: fc.integer({ min: 0, max: 2 }),
    }),
    { minLength: 1, maxLength: 6 },
  ),
  bore: fc.array(fc.record({ rise: fc.integer({ min: 11, max: 90 }), long: fc.integer({ min: 37, max: 210 }) }), {
    maxLength: 3,
  }),
});

test("any turned part is a legible print on one sheet", () => {
  fc.assert(
    fc.property(turned, fc.constantFrom("en", "de", "fr", "zh"), ({ steps, bore }, language) => {
      let x = 20 + bore.reduce((sum, { rise }) => sum + 2 * rise, 0) / 10,
        z = 0;
      const least = 11,
        outside = [`L X+${bore.length > 0 ? x : 0} Z+0`],
        sizes: NonNullable<Parameters<typeof drawnTask>[0]["sizes"]> = [];
      for (const { rise, long, corner, deviation } of steps) {
        x = Math.round(10 * x + 2 * rise) / 10;
        outside.push(`L X+${x}`);
        if (corner > 3) outside.push(corner > 8 ? "RND R0.6" : "CHF 0.5");
        sizes.push({
          kind: "diameter",
          at: z - long / 20,
          nominal: x,
          ...((
            [
              { upper: 0, lower: -0.021 },
              { upper: 0.05, lower: -0.05 },
              { upper: 0, lower: 0 },
            ] as const
          )[deviation] ?? { upper: 0, lower: 0 }),
        });
        z = Math.round(10 * z - long) / 10;
        outside.push(`L Z${z}`);
      }
      const end = Math.round(10 * x + 60) / 10;
      outside.push(`L X+${end}`);
      let d = 20 + bore.reduce((sum, { rise }) => sum + 2 * rise, 0) / 10 - 2,
        depth = 0;
      const inside = [`L X+${d} Z+0`];
      for (const { rise, long } of bore) {
        depth = Math.round(10 * depth - long) / 10;
        inside.push(`L Z${depth}`);
        d = Math.max(least, Math.round(10 * d - 2 * rise) / 10);
        inside.push(`L X+${d}`);
      }
      const drawn = drawnTask({
        part: {
          blank: [
            `BLK FORM CYLINDER Z D${end} L${Math.round(Math.max(-z, -depth) + 30)} DIST+1${bore.length > 0 ? ` DI${least}` : ""}`,
          ],
          outside,
          ...(bore.length > 0 && { bore: [...inside, `L X+${least}`] }),
        },
        sizes,
        rules: { rz: [{ from: 0, to: z, most: 6.3 }] },
      });
      const print = drawn && drawingOnSheet(forMaker(drawn, LANGUAGES[language]), SHEET);
      expect(print).not.toBeNull();
      if (print) expect(faultsOf(print)).toEqual([]);
      expect(print?.width).toBeLessThanOrEqual(SHEET.width);
      expect(print?.height).toBeLessThanOrEqual(SHEET.height);
    }),
    { numRuns: 60 },
  );
});

/** The faults in the print of a generated part. */
function wrongWith(turned: Parameters<typeof partOf>[0], language: keyof typeof LANGUAGES): readonly string[] {
  const drawn = drawnTask(partOf(turned)),
    print = drawn && drawingOnSheet(forMaker(drawn, LANGUAGES[language]), SHEET);
  expect(drawn?.issues).toEqual([]);
  expect(print).not.toBeNull();
  expect(print?.width).toBeLessThanOrEqual(SHEET.width);
  expect(print?.height).toBeLessThanOrEqual(SHEET.height);
  return print ? faultsOf(print) : [];
}
const languages = fc.constantFrom("en", "de", "fr", "zh");
const THROUGH = "a thin line through";

test("a part of any size with undercuts, grooves, threads, cones and chamfers, outside and inside, is a legible print on one sheet", () => {
  fc.assert(
    fc.property(turnedParts, languages, (turned, language) => {
      // In one or two of two hundred parts a leader has to cross a number, which stays legible over the line.
      expect(wrongWith(turned, language).filter((fault) => !fault.startsWith(THROUGH))).toEqual([]);
    }),
    { numRuns: 80 },
  );
});

test("in the print of a part hardly ever a line runs through a number", () => {
  const parts = fc.sample(fc.tuple(turnedParts, languages), { numRuns: 80, seed: 20_261_123 });
  expect(parts.filter(([turned, language]) => wrongWith(turned, language).length > 0).length).toBeLessThanOrEqual(1);
});
