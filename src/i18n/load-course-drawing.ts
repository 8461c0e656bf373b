import type { CourseDrawingTexts } from "./en/course-drawing.ts";
import type { Language } from "./languages.ts";

/** The texts of workshop drawings, fetched when one is shown. */
export async function loadCourseDrawing(language: Language): Promise<CourseDrawingTexts> {
  switch (language) {
    case "en":
      return (await import("./en/course-drawing.ts")).courseDrawing;
    case "de":
      return (await import("./de/course-drawing.ts")).courseDrawing;
    case "fr":
      return (await import("./fr/course-drawing.ts")).courseDrawing;
    case "zh":
      return (await import("./zh/course-drawing.ts")).courseDrawing;
  }
}
