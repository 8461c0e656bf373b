import type { CourseTaskTexts } from "./en/course-task.ts";
import type { Language } from "./languages.ts";

/** The texts of a task that is worked on, fetched when one is open. */
export async function loadCourseTask(language: Language): Promise<CourseTaskTexts> {
  switch (language) {
    case "en":
      return (await import("./en/course-task.ts")).courseTask;
    case "de":
      return (await import("./de/course-task.ts")).courseTask;
    case "fr":
      return (await import("./fr/course-task.ts")).courseTask;
    case "zh":
      return (await import("./zh/course-task.ts")).courseTask;
  }
}
