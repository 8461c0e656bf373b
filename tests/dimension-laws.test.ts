import { beforeAll, describe, expect, test } from "vitest";
import { fetchTexts, texts } from "../src/app/base/settings/loaded-texts.ts";
import { numberIn } from "../src/app/pictures/help/number-in.ts";
import { printWords } from "../src/features/course/drawing/print-words.ts";
import { drawnDimensions } from "../src/features/contour/drawing-dimensions.ts";
import { sheetWords } from "../src/features/sheet/sheet-words.ts";
import { LANGUAGES, type Language } from "../src/i18n/languages.ts";
import { lengthsIn } from "../src/i18n/lengths.ts";
import { part, type Segment } from "../src/kernel/geometry/point.ts";
import { plannedPart } from "../src/planning/part/planned-part.ts";
import { readRows } from "../src/program/job/contour-rows.ts";
import type { Diameter } from "../src/kernel/units.ts";
import type { Size } from "../src/view/camera.ts";
import type { HelpWords } from "../src/view/help/lettering.ts";
import { labelsOverlap, runsThrough, textWidth, type LabelBox } from "../src/view/dimensions/labels.ts";
import {
  placedDimensions,
  type DimensionPaper,
  type DimensionRequest,
  type PlacedDimension,
} from "../src/view/dimensions/placed-dimensions.ts";
import { forMaker } from "../src/view/drawing/maker.ts";
import { drawingOnSheet, partDrawing } from "../src/view/drawing/part-drawing.ts";
import { contourDrawing } from "../src/view/help/contour-drawing.ts";
import { forSetter } from "../src/view/drawing/setter.ts";
import { faultsOf } from "./drawing-faults.ts";
import { cycles, exampleOf, flat, pictured } from "./help/drawings.ts";
import { PART_NAMES, partOfTrade } from "./planning/parts.ts";

beforeAll(async () => {
  for (const language of LANGUAGES)
    for (const name of ["workplace", "sheet", "course-drawing"] as const) await fetchTexts(language, name);
});

/** Texts over one another, and those outside of the drawing. */
function misplaced(boxes: readonly LabelBox[], { width, height }: Size): string[] {
  const over = boxes.flatMap((a, i) =>
    boxes.slice(i + 1).flatMap((b) => (labelsOverlap(a, b) ? [`${JSON.stringify(a)} over ${JSON.stringify(b)}`] : [])),
  );
  const out = boxes.filter((b) => b.x < 0 || b.y < 0 || b.x + b.width > width || b.y + b.height > height);
  return [...over, ...out.map((b) => `${JSON.stringify(b)} outside`)];
}

/** Lines of one dimension through the text of another. */
const crossed = (placed: readonly PlacedDimension[]): number =>
  placed
    .flatMap((one) => placed.map((other) => [one, other] as const))
    .filter(([one, other]) => one !== other && one.pieces.some((piece) => runsThrough(piece, other.box))).length;

const parts = PART_NAMES.map((name) => {
  const read = partOfTrade(name),
    { blank, part: planned, clamping } = plannedPart(read);
  const outlines = { outside: readRows(read.outside), bore: readRows(read.inside) };
  return { name, rows: read.outside, blank, rings: planned?.rings ?? [], clamping, ...outlines };
});

const SAMPLES = [0, 0.5, -7, 12.345, -104.25, 1234.5];
const widths = (written: readonly string[]): string => written.map((text) => textWidth(text, 1)).join(" ");

/** The layout depends on texts by their widths alone: of languages whose texts are as wide, the first stands for all. */
function unlike(written: (language: Language) => readonly string[]): readonly Language[] {
  const all = LANGUAGES.map((language) => [widths(written(language)), language] as const);
  return all.filter(([own], i) => all.findIndex(([other]) => other === own) === i).map(([, language]) => language);
}

describe("help pictures", () => {
  const saidIn = (language: Language): HelpWords => {
    const { help } = texts(language);
    return {
      number: numberIn(language, null),
      element: [help.element.none, help.element.chamfer, help.element.radius],
      reserved: help.reserved,
      notToScale: help.notToScale,
    };
  };
  test.each(cycles.map((cycle) => [cycle.number, cycle] as const))("of cycle %i", (_, cycle) => {
    const [first = "en", ...others] = unlike((language) =>
      SAMPLES.flatMap((value) =>
        [0, 1, 3].map((decimals) => saidIn(language).number(value, decimals, { kind: "length" })),
      ),
    );
    const { element, reserved, notToScale } = saidIn(first),
      words = [...element, reserved, notToScale];
    const picture = pictured(cycle, exampleOf(cycle));
    for (const size of [
      { width: 300, height: 190 },
      { width: 420, height: 280 },
      { width: 860, height: 520 },
    ])
      for (const q of [null, ...Object.keys(cycle.params)]) {
        const lawful = (language: Language) => {
          const drawing = picture?.(q, size, saidIn(language));
          expect(drawing && misplaced(drawing.labels, size), `${String(q)} ${language}`).toEqual([]);
          return flat(drawing?.marks ?? []).flatMap((mark) => (mark.kind === "text" ? [mark.text] : []));
        };
        const isInWords = lawful(first).some((text) => words.some((word) => text.includes(word)));
        for (const language of isInWords ? LANGUAGES.filter((each) => each !== first) : others) lawful(language);
      }
  });
});

test.each(parts.map((each) => [each.name, each] as const))(
  "drawings of %s",
  (_, { blank, rings, clamping, ...own }) => {
    const outside = own.outside.contour.segments,
      bore = own.bore.contour.segments;
    const work = { blank, rings, outside, bore, sizes: [], threads: [], marks: [] };
    const printIn = (language: Language) => printWords(texts(language, "course-drawing"), language);
    for (const language of unlike((each) =>
      Object.values(printIn(each)).flatMap((word: (...values: number[]) => string) =>
        SAMPLES.map((value) => word(value, value)),
      ),
    )) {
      const content = forMaker(work, printIn(language));
      const prints = [
        partDrawing(content, { width: 178, height: 128 }),
        partDrawing(content, { width: 84, height: 128 }),
        drawingOnSheet(content, { width: 275, height: 158 }),
      ];
      expect(prints.map((print) => print && faultsOf(print))).toEqual(prints.map(() => []));
    }
    const sheetIn = (language: Language) =>
      sheetWords(texts(language), texts(language, "sheet"), lengthsIn(language, "mm", 1));
    for (const language of unlike((each) => {
      const { diameter, length, position, thread } = sheetIn(each);
      return SAMPLES.flatMap((v) => [diameter(v as Diameter), length(v), position(v), thread("⌀20", v, 2)]);
    })) {
      const words = sheetIn(language);
      const measured = [...outside, ...bore].flatMap((s, i): DimensionRequest[] =>
        s.kind === "line" && i % 3 === 0
          ? [{ ...measuredOn(s, String(i), words.length(part.lengthOf(s))), needed: false }]
          : [],
      );
      const contours = [{ segments: outside }, { segments: bore }];
      const content = forSetter({ blank, finished: rings, contours, clamping, measured: measured.slice(0, 4) }, words);
      for (const room of [
        { width: 124, height: 96 },
        { width: 70, height: 96 },
      ]) {
        const sheet = partDrawing(content, room);
        const boxes = sheet?.texts.map(({ box }) => box) ?? [];
        expect(boxes).not.toEqual([]);
        expect(sheet && misplaced(boxes, sheet)).toEqual([]);
      }
    }
  },
);

test.each(parts.map((each) => [each.name, each] as const))(
  "the contour of %s, with measurements",
  (_, { rows, outside }) => {
    const askedIn = (language: Language) =>
      drawnDimensions({ rows, reading: outside, chosen: null, language, texts: texts(language).contour });
    for (const size of [
      { width: 390, height: 420 },
      { width: 760, height: 520 },
    ]) {
      const picture = contourDrawing({
        contour: outside.contour.segments,
        rowOfSegment: outside.rowOfSegment,
        ends: outside.rows.map(({ end }) => end),
        faulty: new Set(),
        active: null,
        size,
        margin: { left: 66, right: 100, top: 34, bottom: 78 },
      });
      const paper: DimensionPaper = {
        camera: picture.camera,
        unit: 1,
        size,
        room: { x: 48, y: 2, width: size.width - 50, height: size.height - 26 },
        kept: picture.kept,
        avoid: picture.avoid,
        target: { width: 40, height: 22 },
        free: { x: size.width - 60, y: size.height - 80 },
      };
      for (const language of unlike((each) => askedIn(each).flatMap(({ text, caption = "" }) => [text, caption]))) {
        const placed = placedDimensions(paper, askedIn(language));
        expect(misplaced([...placed.map(({ box }) => box)], size)).toEqual([]);
      }
      const lines = outside.contour.segments.filter((s) => s.kind === "line").slice(0, 5);
      const fewIn = (language: Language) =>
        lines.map((s, i) => measuredOn(s, String(i), lengthsIn(language, "mm", 1).number(part.lengthOf(s))));
      for (const language of unlike((each) => fewIn(each).map(({ text }) => text))) {
        const measured = placedDimensions({ ...paper, kept: [], avoid: [] }, fewIn(language));
        expect(measured).toHaveLength(lines.length);
        expect(
          misplaced(
            measured.map(({ box }) => box),
            size,
          ),
        ).toEqual([]);
        expect(crossed(measured)).toBeLessThanOrEqual(1);
      }
    }
  },
);

/** A measurement along, across or straight over a segment. */
function measuredOn({ from, to }: Segment, key: string, text: string): DimensionRequest {
  const form = from.r === to.r ? "z" : from.z === to.z ? "r" : "along";
  return { key, text, needed: true, measured: { form, from, to } };
}
