import { loadCourse } from "../../i18n/load-course.ts";
import { laterTexts } from "../../app/base/settings/later-texts.ts";

/** The texts of the course, in the screen language. */
export const { useThem: useCourseTexts, useThemSoon: useCourseTextsSoon, provide: provideCourseTexts } = laterTexts(loadCourse);
