import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { CourseIndex } from "../src/app/records/course/content.ts";
import { outlineSchema, type Outline } from "../src/course/outline.ts";
import { lessonSchema, type Lesson } from "../src/course/lesson.ts";
import { secondsOfPages, secondsOfTask } from "../src/course/study-time.ts";
import { taskSchema, type Task } from "../src/course/task.ts";
import { inScreenLanguage, type InLanguages } from "../src/course/words.ts";
import { LANGUAGES, type Language } from "../src/i18n/languages.ts";

/** A file of the course. Runs in the project folder. */
const dataOf = (name: string): unknown => JSON.parse(readFileSync(join("src", "course", name), "utf8"));

/** The files of a folder of the course. */
const files = (folder: string): readonly unknown[] =>
  !existsSync(join("src", "course", folder))
    ? []
    : readdirSync(join("src", "course", folder))
        .filter((name) => name.endsWith(".json"))
        .sort()
        .map((name) => dataOf(join(folder, name)));

/** The texts of shipped content in a language; every language has some. */
function wordsIn<T>(words: InLanguages<T>, language: Language, id: string): T {
  const found = inScreenLanguage(words, language);
  if (found === undefined) throw new Error(`${id} says nothing`);
  return found;
}

/** The facts of all lessons that the list shows without opening a lesson, in a language. */
export function courseIndex(
  { chapters, paths }: Outline,
  lessons: readonly Lesson[],
  tasks: readonly Task[],
  language: Language,
): CourseIndex {
  const byId = new Map(tasks.map((task) => [task.id, task]));
  return {
    chapters: chapters.map(({ words, ...chapter }) => ({ ...chapter, ...wordsIn(words, language, chapter.id) })),
    paths: paths.map(({ words, ...path }) => ({ ...path, ...wordsIn(words, language, path.id) })),
    lessons: [...lessons]
      .sort((a, b) => a.number - b.number)
      .map((lesson) => {
        const { id, number, pages, words, tasks: asked } = lesson;
        const { title, aim } = wordsIn(words, language, id);
        return {
          id,
          number,
          title,
          aim,
          pages: pages.length,
          seconds: Math.round(secondsOfPages(lesson)),
          questions: pages.flatMap((page, i) => (page.question ? [{ id: page.question.id, page: i + 1 }] : [])),
          tasks: asked.flatMap((each) => {
            const task = byId.get(each);
            if (!task) return [];
            const { title: name } = wordsIn(task.words, language, each);
            return [{ id: each, kind: task.kind, title: name, seconds: Math.round(secondsOfTask(task)) }];
          }),
        };
      }),
  };
}

/** The modules that the page imports by the name in src/app/records/course/course-index.d.ts, by their ids. */
export function courseModules(): Readonly<Record<string, string>> {
  const id = "virtual:course-index";
  const [lessons, tasks] = [
    files("lessons").map((each) => lessonSchema.parse(each)),
    files("tasks").map((each) => taskSchema.parse(each)),
  ];
  const outline = outlineSchema.parse(dataOf("outline.json"));
  const cases = LANGUAGES.map((language) => `${language}: () => import("${id}/${language}")`);
  return {
    [id]: `export const lessonNumbers = ${JSON.stringify(
      Object.fromEntries(lessons.map((each) => [each.id, each.number])),
    )};\nconst made = { ${cases.join(", ")} };\nexport const courseIndexOf = async (language) => (await made[language]()).index;`,
    ...Object.fromEntries(
      LANGUAGES.map((language) => [
        `${id}/${language}`,
        `export const index = ${JSON.stringify(courseIndex(outline, lessons, tasks, language))};`,
      ]),
    ),
  };
}
