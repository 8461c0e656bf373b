import { useEffect } from "react";
import { useCourseIndex } from "../../app/records/course/content.ts";
import { coursePage, usePlace } from "../../app/place/place.ts";
import { CourseList } from "./CourseList.tsx";
import { LessonView } from "./LessonView.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import "./course.css";

/** The course, which replaces the start page: the list of lessons, or the open one. */
export function CoursePage() {
  const t = useTexts("course");
  const { lessons } = useCourseIndex();
  const lesson = usePlace((p) => coursePage(p)?.lesson ?? null);
  const at = usePlace((p) => coursePage(p)?.at ?? null);
  const open = lessons.find(({ id }) => id === lesson);
  const opened = open ? t.openLesson(String(open.number), open.title) : t.title;
  const title = open && at === "tasks" ? `${t.tasks}, ${opened}` : opened;
  useEffect(() => {
    document.title = `${title} · Turnwise`;
  }, [title]);
  return lesson === null ? <CourseList /> : <LessonView key={lesson} entry={open ?? null} />;
}
