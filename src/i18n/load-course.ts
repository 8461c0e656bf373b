import type { CourseTexts } from "./en/course.ts";
import type { Language } from "./languages.ts";

/** The texts of the course, fetched when it is shown. */
export async function loadCourse(language: Language): Promise<CourseTexts> {
  switch (language) {
    case "en":
      return (await import("./en/course.ts")).course;
    case "de":
      return (await import("./de/course.ts")).course;
    case "fr":
      return (await import("./fr/course.ts")).course;
    case "zh":
      return (await import("./zh/course.ts")).course;
  }
}
