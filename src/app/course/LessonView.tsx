import { useEffect } from "react";
import { useCourseIndex, type LessonEntry } from "./content.ts";
import { courseHref } from "./course-links.ts";
import { useCoursePlace } from "./course-place.ts";
import { noteLessonPage } from "./progress.ts";
import { useCourseTexts } from "./use-course-texts.ts";

/** A lesson: its pages one after the other, then its tasks. */
export function LessonView({ id, entry }: { readonly id: string; readonly entry: LessonEntry | null }) {
  const t = useCourseTexts();
  const { lessons } = useCourseIndex();
  const page = useCoursePlace((p) => p.page);
  const number = entry?.number;
  useEffect(() => {
    if (number !== undefined) noteLessonPage({ lesson: id, number, page });
  }, [id, number, page]);
  if (!entry) {
    return (
      <main className="course-page">
        <p>{t.missing}</p>
        <a className="button" href={courseHref()}>{t.toList}</a>
      </main>
    );
  }
  return <main className="course-page">{lessons.length}</main>;
}
