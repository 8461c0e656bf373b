import type { Lesson } from "../../course/lesson.ts";

type LessonPicturePage = Lesson["pages"][number];

/** A page of a lesson as it is shown: its program, which may be that of a page before, and what of it. */
export interface LessonPageOf extends Omit<LessonPicturePage, "program"> {
  /** Tells this page from the others. */
  readonly key: string;
  readonly program: readonly string[];
}

/** The pages of a lesson, each with its program. */
export function pagesOf({ id, pages }: Lesson): readonly LessonPageOf[] {
  let last: readonly string[] = [];
  return pages.map(({ program, ...page }, i) => {
    last = program ?? last;
    return { ...page, key: `${id} ${i}`, program: last };
  });
}
