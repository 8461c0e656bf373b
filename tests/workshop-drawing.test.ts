import { describe, expect, test } from "vitest";
import { printWords } from "../src/features/course/drawing/print-words.ts";
import { drawnTask } from "../src/course/drawn-task.ts";
import type { Task } from "../src/course/task.ts";
import { courseDrawing as english } from "../src/i18n/en/course-drawing.ts";
import { courseDrawing as german } from "../src/i18n/de/course-drawing.ts";
import { labelsOverlap } from "../src/view/dimensions/labels.ts";
import { forMaker } from "../src/view/drawing/maker.ts";
import { partDrawing, type PartDrawing } from "../src/view/drawing/part-drawing.ts";
import { FIGURES, NEXT, nominalWidth, SMALL, widthOf } from "../src/view/drawing/paper.ts";

/** The drawn data of a task. */
type Drawn = Pick<Task, "part" | "sizes" | "rules">;

const shaft: Drawn = {
  part: {
    blank: ["BLK FORM CYLINDER Z D62 L95 DIST+2"],
    outside: [
      "L X+0 Z+0",
      "L X+28",
      "CHF 1.5",
      "L Z-22.4",
      "RND R1.2",
      "L X+40",
      "CHF 0.5",
      "L Z-38",
      "L X+35 Z-41.5",
      "L Z-46",
      "L X+46",
      "L X+50 Z-61",
      "L X+62",
    ],
  },
  sizes: [
    { kind: "diameter", at: -11, nominal: 28, upper: -0.007, lower: -0.02 },
    {
      kind: "diameter",
      at: -30,
      nominal: 40,
      upper: 0.05,
      lower: -0.05,
    },
    { kind: "face", at: 34, nominal: -22.4, upper: 0.1, lower: 0 },
  ],
  rules: {
    rz: [
      { from: 0, to: -22, most: 6.3 },
      { from: -22.4, to: -61, most: 25 },
    ],
  },
};
const flange: Drawn = {
  part: {
    blank: ["BLK FORM CYLINDER Z D100 L90 DIST+2 DI24"],
    outside: [
      "L X+24 Z+0",
      "L X+46",
      "L Z-6",
      "L X+56",
      "L Z+0",
      "L X+62",
      "CHF 1.5",
      "L Z-40",
      "RND R1.5",
      "L X+80",
      "CHF 1",
      "L Z-58",
      "RND R1.2",
      "L X+100",
    ],
    bore: ["L X+40 Z+0", "CHF 1", "L Z-32", "RND R1", "L X+24"],
  },
  sizes: [
    { kind: "bore", at: -20, nominal: 40, upper: 0.025, lower: 0 },
    {
      kind: "diameter",
      at: -20,
      nominal: 62,
      upper: 0,
      lower: -0.03,
    },
  ],
  rules: { rz: [{ from: 0, to: -58, most: 16 }] },
};
const thread: Drawn = {
  part: {
    blank: ["BLK FORM CYLINDER Z D36 L70 DIST+1"],
    outside: ["L X+0 Z+0", "L X+30", "CHF 1.5", "L Z-20", "L X+26", "L Z-25", "L X+36"],
    threads: [{ from: 0, to: -20, crest: 30, root: 28.16, name: "M30×1.5" }],
  },
  rules: {},
};
const ball: Drawn = {
  part: {
    blank: ["BLK FORM CYLINDER Z D50 L60 DIST+1"],
    outside: ["L X+0 Z+0", "CR X+40 Z-20 R20 DR+", "L X+44", "L Z-34", "CR X+44 Z-41 R5 DR+", "L Z-50"],
  },
  rules: { rz: [{ from: 0, to: -50, most: 10 }] },
};
const many: Drawn = {
  part: {
    blank: ["BLK FORM CYLINDER Z D80 L130 DIST+1"],
    outside: [
      "L X+0 Z+0",
      "L X+20",
      "CHF 1",
      "L Z-7",
      "L X+17",
      "L Z-9",
      "L X+25",
      "CHF 0.5",
      "L Z-18",
      "RND R2",
      "L X+30",
      "CHF 0.8",
      "L Z-27",
      "L X+26",
      "L Z-31",
      "L X+34",
      "L Z-44.5",
      "RND R3",
      "L X+48",
      "CHF 2",
      "L Z-60",
      "L X+55 Z-75",
      "L X+63.4",
      "L Z-81",
      "L X+70",
      "L Z-95",
      "L X+80",
    ],
  },
  sizes: [-3, -12, -22, -40, -50, -85].map((at, i) => ({
    kind: "diameter" as const,
    at,
    nominal: [20, 25, 30, 34, 48, 70][i] ?? 0,
    upper: 0.021,
    lower: -0.013,
  })),
  rules: {
    rz: [
      { from: 0, to: -7, most: 4 },
      { from: -31, to: -44, most: 6.3 },
      { from: -60, to: -75, most: 16 },
    ],
  },
};
const works = { shaft, flange, thread, ball, many };

const ROOMS = { wide: { width: 178, height: 130 }, narrow: { width: 92, height: 120 } };

function drawn(work: Drawn, room: keyof typeof ROOMS, language: "en" | "de" = "en"): PartDrawing {
  const part = drawnTask(work);
  const print =
    part && partDrawing(forMaker(part, printWords(language === "de" ? german : english, language)), ROOMS[room]);
  if (!print) throw new Error("nothing drawn");
  return print;
}

/** The drawing as a file, with its letters as placed on the page. */
function svgOf({ width, height, shapes, texts }: PartDrawing): string {
  const n = (v: number) => String(Math.round(v * 100) / 100 + 0);
  const style =
    `svg{background:#fff;fill:none;stroke:#000;stroke-width:.15}.outline{stroke-width:.5}.edge{stroke-width:.35}.arrow{fill:#000}` +
    `.axis{stroke-dasharray:6 1 1 1}.section{fill:#ddd;stroke:none;fill-rule:evenodd}text{font:3px monospace;fill:#000;stroke:#fff;` +
    `stroke-width:.9;paint-order:stroke;dominant-baseline:central}`;
  const rows = texts.map((t) => {
    const start = t.at.x - widthOf(t) / 2,
      next = start + nominalWidth(t) + NEXT,
      small = n(FIGURES * SMALL);
    const turn = t.turned ? ` transform="rotate(-90 ${n(t.at.x)} ${n(t.at.y)})"` : "";
    return (
      `  <g${turn}><text x="${n(start)}" y="${n(t.at.y)}">${t.text}</text>` +
      (t.upper === undefined
        ? ""
        : `<text font-size="${small}" style="font-size:${small}px" x="${n(next)}" y="${n(t.at.y - 1.2)}">${t.upper}</text>`) +
      (t.lower === undefined
        ? ""
        : `<text style="font-size:${small}px" x="${n(next)}" y="${n(t.at.y + 1.2)}">${t.lower}</text>`) +
      "</g>"
    );
  });
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${n(width)} ${n(height)}" width="${n(width)}mm">`,
    ` <style>${style}</style>`,
    ...shapes.map(({ role, d }) => `  <path class="${role}" d="${d}"/>`),
    ...rows,
    "</svg>",
    "",
  ].join("\n");
}

describe.each(Object.entries(works))("%s", (name, work) => {
  test.each(["wide", "narrow"] as const)("is drawn, %s", async (room) => {
    await expect(svgOf(drawn(work, room, room === "narrow" ? "de" : "en"))).toMatchFileSnapshot(
      `drawings/${name}-${room}.svg`,
    );
  });
  test.each(["wide", "narrow"] as const)("has no overlapping text and none outside, %s", (room) => {
    const { texts, width, height } = drawn(work, room);
    const over = texts.flatMap((a, i) =>
      texts
        .slice(i + 1)
        .filter((b) => labelsOverlap(a.box, b.box))
        .map((b) => `${a.text} over ${b.text}`),
    );
    const out = texts.filter(
      ({ box }) => box.x < 0 || box.y < 0 || box.x + box.width > width || box.y + box.height > height,
    );
    expect([...over, ...out.map(({ text }) => `${text} outside`)]).toEqual([]);
  });
});

test("each size is in the list, with its deviations", () => {
  const { list, general } = drawn(flange, "wide");
  expect(general).toBe("Rz 16");
  expect(list.find(({ kind }) => kind === "bore")?.size).toEqual({ text: "⌀40", upper: "+0.025", lower: "0" });
  expect(
    list
      .filter(({ kind }) => kind === "length")
      .map(({ size }) => size.text)
      .sort(),
  ).toEqual(["32", "40", "58", "6"]);
});

test("a length behind Z0 grows where Z falls", () => {
  const { list } = drawn(shaft, "wide");
  expect(list.find(({ kind, at }) => kind === "length" && at[0] === -22.4)?.size).toEqual({
    text: "22.4",
    upper: "0",
    lower: "−0.1",
  });
});

test("a thread has its name", () => {
  expect(drawn(thread, "wide").list.find(({ kind }) => kind === "thread")?.size.text).toBe("M30×1.5");
});
