import { isDeepStrictEqual } from "node:util";
import { describe, expect, test } from "vitest";
import { lessonSchema, type Lesson } from "../../src/course/lesson.ts";
import { stepsPlayed, parameterValueIn, withParameterValue } from "../../src/course/playback-range.ts";
import { programOfLines } from "../../src/course/task-start.ts";
import { taskSchema } from "../../src/course/task.ts";
import { LESSON_LANGUAGES } from "../../src/i18n/languages.ts";
import { radius, toDiameter } from "../../src/kernel/units.ts";
import { parse } from "../../src/nc/parse.ts";
import { run } from "../../src/program/run/run.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";

const files = import.meta.glob<unknown>("../../src/course/lessons/*.json", { eager: true, import: "default" });
const tasks = import.meta.glob<unknown>("../../src/course/tasks/*.json", { eager: true, import: "default" });
const named = Object.entries(files).map(
  ([path, raw]) => [path.slice(path.lastIndexOf("/") + 1, -".json".length), raw] as const,
);
const ran = (lines: readonly string[]) => run(parse(programOfLines(lines)), { tools: shippedTools, rapid: 10_000 });

/** The programs of the pages; a page without one has that of an earlier page. */
function programs({ pages }: Lesson): readonly (readonly string[])[] {
  let last: readonly string[] = [];
  return pages.map(({ program }) => (last = program ?? last));
}

test("the lessons are numbered from 1 without gaps or duplicates", () => {
  const all = named.map(([, raw]) => lessonSchema.parse(raw));
  expect(all.map(({ number }) => number).toSorted((a, b) => a - b)).toEqual(all.map((_, i) => i + 1));
  expect(new Set(all.map(({ id }) => id)).size).toBe(all.length);
  expect(all.length).toBeGreaterThanOrEqual(20);
});

test("every task belongs to one lesson", () => {
  const asked = named.flatMap(([, raw]) => lessonSchema.parse(raw).tasks);
  const there = Object.keys(tasks).map((path) => path.slice(path.lastIndexOf("/") + 1, -".json".length));
  expect(asked.toSorted()).toEqual(there.toSorted());
  expect(there.length).toBeGreaterThanOrEqual(60);
});

describe.each(named)("%s", (name, raw) => {
  const lesson = lessonSchema.parse(raw);
  const { pages, words, example } = lesson;

  test("is named as its file, and has every page in every language", () => {
    expect(name).toBe(`${String(lesson.number).padStart(2, "0")}-${lesson.id}`);
    for (const language of LESSON_LANGUAGES)
      expect([language, words[language]?.pages.length]).toEqual([language, pages.length]);
  });

  test("its pictures move between the stated blocks", () => {
    programs(lesson).forEach((program, i) => {
      const { steps } = ran(program),
        { blocks } = pages[i] ?? {};
      expect(steps.length, `page ${i + 1}`).toBeGreaterThan(0);
      if (!blocks) return;
      const { first, last } = stepsPlayed(steps, blocks);
      const seen = steps.slice(first, last + 1).map(({ block }) => block);
      expect(Math.min(...seen), `page ${i + 1}`).toBeGreaterThanOrEqual(blocks.from);
      expect(Math.max(...seen), `page ${i + 1}`).toBeLessThanOrEqual(blocks.to);
    });
  });

  test("the frame of a picture contains its moves", () => {
    programs(lesson).forEach((program, i) => {
      const { blocks, frame } = pages[i] ?? {};
      if (!frame) return;
      const {
        x: [low, high],
        z: [left, right],
      } = frame;
      expect(low, `page ${i + 1}`).toBeLessThan(high);
      expect(left, `page ${i + 1}`).toBeLessThan(right);
      const { steps } = ran(program),
        { first, last } = stepsPlayed(steps, blocks);
      const fed = steps
        .slice(first, last + 1)
        .filter(({ move }) => move.kind !== "rapid")
        .map(({ move }) => move.to);
      const seen = fed.filter(
        ({ z, r }) => z > left && z < right && toDiameter(radius(r)) > low && toDiameter(radius(r)) < high,
      );
      expect(seen.length, `page ${i + 1}`).toBeGreaterThan(0);
    });
  });

  test("a slider's parameter is in the program, within its range, and every value has a path", () => {
    programs(lesson).forEach((program, i) => {
      const { slide } = pages[i] ?? {};
      if (!slide) return;
      const { q, from, to, step } = slide,
        now = parameterValueIn(program, q);
      expect(now, `page ${i + 1}: ${q}`).not.toBeNull();
      expect(now, `page ${i + 1}: ${q}`).toBeGreaterThanOrEqual(from);
      expect(now, `page ${i + 1}: ${q}`).toBeLessThanOrEqual(to);
      const steps = ((now ?? 0) - from) / step;
      expect(steps, `page ${i + 1}: ${q} stands between two places of the slider`).toBeCloseTo(Math.round(steps), 6);
      for (const value of [from, to])
        expect(
          ran(withParameterValue(program, q, value)).steps.length,
          `page ${i + 1}: ${q} = ${value}`,
        ).toBeGreaterThan(0);
    });
  });

  test("no page is longer than a screen of text", () => {
    const long = (words.en?.pages ?? []).map((text) => text.split(/\s+/).length).filter((count) => count > 106);
    expect(long).toEqual([]);
  });

  test("its example runs", () => {
    if (example) expect(ran(example).steps.length).toBeGreaterThan(0);
  });
});

/** Times that a page states, with the value and the block that they are for. */
const TIMES: readonly (readonly [lesson: string, page: number, block: number, value: string, time: string])[] = [
  ["recess-turning", 3, 9, "", "54.6 s"],
  ["recess-turning", 3, 9, "Q507=1", "1 min 6 s"],
  ["build-852", 4, 9, "", "1 min 5 s"],
  ["valleys", 3, 11, "", "59.4 s"],
  ["valleys", 3, 11, "Q488=0", "50.3 s"],
  ["recessing", 2, 9, "", "1 min 30 s"],
  ["recessing", 3, 9, "Q562=1", "1 min 25 s"],
  ["cutting-data", 2, 11, "", "71 s"],
  ["from-a-drawing", 3, 11, "", "45 s"],
  ["from-a-drawing", 3, 27, "", "43 s"],
  ["from-a-drawing", 3, 36, "", "36 s"],
];

test.each(TIMES)("the time on page %s %i is that of the run: block %i %s %s", (id, page, block, value, time) => {
  const lesson = named.map(([, raw]) => lessonSchema.parse(raw)).find((each) => each.id === id);
  if (!lesson) throw new Error("missing");
  expect(lesson.words.en?.pages[page - 1]).toContain(time);
  const [q = "", of = ""] = value.split("=");
  const program = programs(lesson)[page - 1] ?? [];
  const { steps } = ran(value === "" ? program : withParameterValue(program, q, Number(of)));
  const seconds = steps.reduce((sum, step) => sum + (step.block === block ? step.seconds : 0), 0);
  const [, minutes = "0", rest = ""] = /^(?:(\d+) min )?([\d.]+) s$/.exec(time) ?? [];
  expect(seconds).toBeCloseTo(60 * Number(minutes) + Number(rest), rest.includes(".") ? 1 : 0);
});

/** Lessons in the order of the course. */
const inOrder = named.map(([, raw]) => lessonSchema.parse(raw)).toSorted((a, b) => a.number - b.number);

describe("the printed examples", () => {
  const pages = import.meta.glob<string>("../programs/cycle-*-tnc640-fr.h", {
    query: "?raw",
    import: "default",
    eager: true,
  });
  const programOf = (cycle: number) => pages[`../programs/cycle-${cycle}-tnc640-fr.h`] ?? "";
  /** Values and contour of a program as a page prints them, without block numbers and words. */
  const said = (text: string) => ({
    values: Object.fromEntries(
      [...text.matchAll(/\b(Q\d+) ?=?([+-][\d.]+)/g)].map(([, q, value]) => [q, Number(value)]),
    ),
    contour: text
      .split("\n")
      .map((line) =>
        line
          .replace(/^\d+ +/, "")
          .replaceAll(/ +/g, " ")
          .trim(),
      )
      .filter((line) => /^(L (X\S+( Z\S+)?|Z\S+)|RND R\S+|CHF \S+)$/.test(line)),
  });

  test.each([812, 820, 852])("%i is built from an empty page by the middle of the course", (cycle) => {
    const printed = said(programOf(cycle));
    expect(Object.keys(printed.values).length).toBeGreaterThanOrEqual(14);
    const order = inOrder.flatMap((lesson) =>
      lesson.tasks.map((id) => taskSchema.parse(tasks[`../../src/course/tasks/${id}.json`])),
    );
    const built = order.findIndex(
      ({ start, rules, solution }) =>
        "empty" in start &&
        rules.cycles?.includes(cycle) === true &&
        isDeepStrictEqual(said(programOfLines(solution ?? [])), printed),
    );
    expect(built).toBeGreaterThanOrEqual(0);
    expect(built + 1).toBeLessThanOrEqual(order.length / 2);
  });
});

test("a lesson number in a text refers to the right lesson", () => {
  const all: Readonly<Record<string, unknown>> = { ...files, ...tasks };
  const names = /(?:lessons?|Lektion(?:en)?|leçons?) (\d+)|第 ?(\d+) ?课/gi;
  for (const language of LESSON_LANGUAGES) {
    const told = Object.entries(all).flatMap(([path, raw]) => {
      const { words } = raw as { words: Partial<Record<string, unknown>> };
      const where = path.slice(path.lastIndexOf("/") + 1, -".json".length).replace(/^\d\d-/, "");
      return [...JSON.stringify(words[language]).matchAll(names)].map(
        ([, n, m]) => `${where}: ${inOrder[Number(n ?? m) - 1]?.id}`,
      );
    });
    expect([language, told.toSorted()]).toEqual([
      language,
      [
        "build-812: speed",
        "build-820: contour",
        "build-820: direction",
        "build-820: valleys",
        "build-852: recess-turning",
        "direction: contour",
        "l02-sharper-corner: valleys",
        "l14-852-empty: build-820",
        "recess-turning: valleys",
        "recessing: build-852",
      ],
    ]);
  }
});
