import { useCourseIndex, type LessonEntry } from "../../app/records/course/content.ts";
import { LessonRow } from "./LessonRow.tsx";
import { PassedBar } from "./PassedBar.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { secondsOfLessons, useStudyTime } from "./use-course-path.ts";

interface Props {
  readonly lessons: readonly LessonEntry[];
  /** The lesson to continue with. */
  readonly next: LessonEntry | null;
}

/** The lessons of a path, one below the other. */
export function LessonList({ lessons, next }: Props) {
  return (
    <ol className="lesson-list">
      {lessons.map((lesson) => (
        <LessonRow key={lesson.id} lesson={lesson} isNext={lesson.id === next?.id} />
      ))}
    </ol>
  );
}

/** The whole course by chapters; the one with the next lesson is open. */
export function ChapterList({ lessons, next }: Props) {
  const t = useTexts("course-path");
  const studyTime = useStudyTime();
  const { chapters } = useCourseIndex();
  return chapters.map(({ id, title, lessons: listed }) => {
    const own = lessons.filter((lesson) => listed.includes(lesson.id));
    const [first, last] = [own[0], own.at(-1)];
    if (!first || !last) return null;
    return (
      <details key={id} className="chapter" open={own.some((lesson) => lesson.id === (next ?? lessons[0])?.id)}>
        <summary>
          <h2>{title}</h2>
          <span className="chapter-facts small">
            <span>{t.range(String(first.number), String(last.number))}</span>
            <span>{studyTime(secondsOfLessons(own))}</span>
            <PassedBar lessons={own} />
          </span>
        </summary>
        <LessonList lessons={own} next={next} />
      </details>
    );
  });
}
