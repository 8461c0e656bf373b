import { producedParts } from "../src/sim/produced-parts.ts";
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { printWords } from "../src/features/course/drawing/print-words.ts";
import { sheetTitleOf } from "../src/features/course/drawing/title-words.ts";
import { answerOf } from "../src/course/judge/answer.ts";
import { drawnProgram } from "../src/course/drawn-program.ts";
import type { DrawnTask } from "../src/course/drawn-task.ts";
import { boxAround } from "../src/kernel/area/box.ts";
import { courseDrawing as english } from "../src/i18n/en/course-drawing.ts";
import { courseDrawing as german } from "../src/i18n/de/course-drawing.ts";
import { drawingSvg, titleBlock } from "../src/view/drawing/drawing-svg.ts";
import { forMaker } from "../src/view/drawing/maker.ts";
import { drawingOnSheet } from "../src/view/drawing/part-drawing.ts";
import { finishedBody, isBody } from "../src/view/solid/bodies.ts";
import { faultsOf } from "./drawing-faults.ts";

const SHEET = { width: 275, height: 158 },
  words = printWords(english, "en");

/** The drawing of the part that a program makes. */
function drawn(text: string, known: Parameters<typeof drawnProgram>[2] = null): DrawnTask | null {
  const answer = answerOf(text),
    wanted = finishedBody(answer.simulation, answer.run.operations);
  return drawnProgram(answer, isBody(wanted) ? wanted : producedParts(answer.simulation), known);
}
const example = (name: string) => readFileSync(new URL(`../src/examples/${name}.h`, import.meta.url), "utf8");
const printOf = (part: DrawnTask | null) => part && drawingOnSheet(forMaker(part, words), SHEET);
/** The sizes of a drawing as written, by kind. */
const sizesOf = (part: DrawnTask | null) =>
  (printOf(part)?.list ?? [])
    .map(({ kind, size }) => `${kind} ${[size.text, size.upper, size.lower].filter(Boolean).join(" ")}`)
    .sort();

test("a program of eight operations is drawn with the sizes of its contours, not of chords", () => {
  expect(sizesOf(drawn(example("flange")))).toEqual([
    "angle 2× 3°",
    "blank (⌀100)",
    "blank (⌀24)",
    "bore ⌀40",
    "chamfer 0.5×45°",
    "chamfer 0.5×45°",
    "chamfer 1.5×45°",
    "chamfer 1×45°",
    "chamfer 1×45°",
    "chamfer 2× 0.3×0.3",
    "diameter ⌀46",
    "diameter ⌀56",
    "diameter ⌀62",
    "diameter ⌀80",
    "length 32",
    "length 4",
    "length 40",
    "length 58",
    "radius 2× R0.4",
    "radius R1",
    "radius R1.2",
    "radius R1.5",
  ]);
});

test.each(["flange", "shaft", "groove", "shoulder", "contour"])(
  "the drawing of %s is a legible print on one sheet",
  (name) => {
    const print = printOf(drawn(example(name)));
    expect(print && faultsOf(print)).toEqual([]);
    expect(print?.height).toBeLessThanOrEqual(SHEET.height);
  },
);

test("threads are drawn by their name and crest, outside and in the bore, and none of their grooves", () => {
  const part = drawn(example("shaft"));
  expect(part?.threads.map(({ name }) => name)).toEqual(["M60×1.5", "M44×1.5"]);
  const outside = part?.outside.filter(({ from, to }) => from.z > -20 && to.z > -20).map(({ kind }) => kind);
  expect(outside?.every((kind) => kind === "line")).toBe(true);
  expect(outside?.length).toBeLessThan(4);
});

const BAR = (moves: string) =>
  `0 BEGIN PGM A MM\n1 BLK FORM CYLINDER Z D48 L93.7 DIST+0.7\n2 FUNCTION MODE TURN\n3 TOOL CALL 1\n` +
  `4 FUNCTION TURNDATA SPIN VCONST:OFF S800\n5 M136\n${moves}90 M30\n91 END PGM A MM\n`;

test("a part turned only by hand is drawn as made; an unturned one is not drawn", () => {
  expect(sizesOf(drawn(BAR("6 L X+41.36 Z+2 R0 FMAX M303\n7 L Z-23.4 F0.2\n8 L X+52\n")))).toEqual([
    "blank (⌀48)",
    "diameter ⌀41.36",
    "length 0.7",
    "length 23.4",
    "radius R0.8",
  ]);
  expect(drawn(BAR("6 L X+60 Z+2 R0 FMAX M303\n7 L Z-23.4 F0.2\n"))).toBeNull();
});

test("of a parted-off bar, the front piece is the part", () => {
  const parted = BAR("")
    .replace("3 TOOL CALL 1", "3 TOOL CALL 10")
    .replace("D48", "D36")
    .replace("90 M30", "6 L X+40 Z-31.3 R0 FMAX M303\n7 L X-1 F0.05\n8 L X+40 FMAX\n90 M30");
  const part = drawn(parted);
  expect(boxAround([...(part?.rings ?? [])]).left).toBeGreaterThan(-33);
});

test("a task's deviations are drawn only on a part with exactly that size", () => {
  const known = (nominal: number) => ({
    sizes: [{ kind: "diameter" as const, at: -20, nominal, upper: 0, lower: -0.03 }],
    rules: {},
  });
  expect(sizesOf(drawn(example("flange"), known(62)))).toContain("diameter ⌀62 0 −0.03");
  expect(sizesOf(drawn(example("flange"), known(62.2)))).toContain("diameter ⌀62");
});

test("the sheet is a separate file: everything within its frame, and names as written", () => {
  const part = drawn(example("groove")),
    print = printOf(part);
  if (!part || !print) throw new Error("nothing drawn");
  const titled = {
    name: "SEAL <A&B> FOR A PUMP WITH A VERY LONG NAME INDEED, FIRST OF TWO, LEFT HAND",
    number: "GROOVE.H",
    material: "C45E",
  };
  const title = sheetTitleOf({ titled, drawn: part, print, words: printWords(german, "de"), t: german });
  const svg = drawingSvg(print, title, { width: 277, height: 190 });
  expect(svg).toContain("SEAL &lt;A&amp;B&gt; FOR");
  expect(svg).toContain(`width="297mm" height="210mm"`);
  for (const width of [277, 259, 120]) {
    const { cells } = titleBlock(title, width);
    expect(cells.filter(({ x, width: wide }) => x < 0 || x + wide > width + 0.01)).toEqual([]);
    expect(cells.length).toBe(title.facts.length + 1);
  }
});
