import { describe, expect, test } from "vitest";
import { lessonSchema, type Lesson } from "../../src/course/lesson.ts";
import { stepsPlayed, valueIn, withSlid } from "../../src/course/played.ts";
import { programOfLines } from "../../src/course/start-of.ts";
import { LANGUAGES } from "../../src/i18n/languages.ts";
import { radius, toDiameter } from "../../src/kernel/units.ts";
import { parse } from "../../src/nc/parse.ts";
import { run } from "../../src/program/run.ts";
import { shippedTools } from "../../src/program/shipped-tools.ts";

const files = import.meta.glob<unknown>("../../src/course/lessons/*.json", { eager: true, import: "default" });
const tasks = import.meta.glob<unknown>("../../src/course/tasks/*.json");
const named = Object.entries(files).map(([path, raw]) => [path.slice(path.lastIndexOf("/") + 1, -".json".length), raw] as const);
const ran = (lines: readonly string[]) => run(parse(programOfLines(lines)), { tools: shippedTools, rapid: 10_000 });

/** The programs of the pages, each with that of a page before where it has none of its own. */
function programs({ pages }: Lesson): readonly (readonly string[])[] {
  let last: readonly string[] = [];
  return pages.map(({ program }) => (last = program ?? last));
}

test("the lessons are numbered from 1 without a gap, and none is there twice", () => {
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

  test("is named as its file, and says every page in every language", () => {
    expect(name).toBe(`${String(lesson.number).padStart(2, "0")}-${lesson.id}`);
    for (const language of LANGUAGES) expect([language, words[language]?.pages.length]).toEqual([language, pages.length]);
  });

  test("its pictures move, from block to block as they say", () => {
    programs(lesson).forEach((program, i) => {
      const { steps } = ran(program), { blocks } = pages[i] ?? {};
      expect(steps.length, `page ${i + 1}`).toBeGreaterThan(0);
      if (!blocks) return;
      const { first, last } = stepsPlayed(steps, blocks);
      const seen = steps.slice(first, last + 1).map(({ block }) => block);
      expect(Math.min(...seen), `page ${i + 1}`).toBeGreaterThanOrEqual(blocks.from);
      expect(Math.max(...seen), `page ${i + 1}`).toBeLessThanOrEqual(blocks.to);
    });
  });

  test("what a picture is framed to is where its moves are", () => {
    programs(lesson).forEach((program, i) => {
      const { blocks, frame } = pages[i] ?? {};
      if (!frame) return;
      const { x: [low, high], z: [left, right] } = frame;
      expect(low, `page ${i + 1}`).toBeLessThan(high);
      expect(left, `page ${i + 1}`).toBeLessThan(right);
      const { steps } = ran(program), { first, last } = stepsPlayed(steps, blocks);
      const fed = steps.slice(first, last + 1).filter(({ move }) => move.kind !== "rapid").map(({ move }) => move.to);
      const seen = fed.filter(({ z, r }) => z > left && z < right && toDiameter(radius(r)) > low && toDiameter(radius(r)) < high);
      expect(seen.length, `page ${i + 1}`).toBeGreaterThan(0);
    });
  });

  test("what is slid stands in the program, within its ends, and makes a path all the way", () => {
    programs(lesson).forEach((program, i) => {
      const { slide } = pages[i] ?? {};
      if (!slide) return;
      const { q, from, to, step } = slide, now = valueIn(program, q);
      expect(now, `page ${i + 1}: ${q}`).not.toBeNull();
      expect(now, `page ${i + 1}: ${q}`).toBeGreaterThanOrEqual(from);
      expect(now, `page ${i + 1}: ${q}`).toBeLessThanOrEqual(to);
      const steps = ((now ?? 0) - from) / step;
      expect(steps, `page ${i + 1}: ${q} stands between two places of the slider`).toBeCloseTo(Math.round(steps), 6);
      for (const value of [from, to])
        expect(ran(withSlid(program, q, value)).steps.length, `page ${i + 1}: ${q} = ${value}`).toBeGreaterThan(0);
    });
  });

  test("its example runs", () => {
    if (example) expect(ran(example).steps.length).toBeGreaterThan(0);
  });
});
