import type { Lesson } from "../../course/lesson.ts";

type LessonPicturePage = Lesson["pages"][number];

/** A page of a lesson with its program, which may be that of a previous page. */
export interface LessonPageOf extends Omit<LessonPicturePage, "program"> {
  /** Identifies the page. */
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
