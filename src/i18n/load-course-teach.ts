import type { CourseTeachTexts } from "./en/course-teach.ts";
import type { Language } from "./languages.ts";

/** The texts for instructors and of what is handed in, fetched when they are needed. */
export async function loadCourseTeach(language: Language): Promise<CourseTeachTexts> {
  switch (language) {
    case "en":
      return (await import("./en/course-teach.ts")).courseTeach;
    case "de":
      return (await import("./de/course-teach.ts")).courseTeach;
    case "fr":
      return (await import("./fr/course-teach.ts")).courseTeach;
    case "zh":
      return (await import("./zh/course-teach.ts")).courseTeach;
  }
}
