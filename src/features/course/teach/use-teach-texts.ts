import { loadCourseTeach } from "../../../i18n/load-course-teach.ts";
import { laterTexts } from "../../../app/base/settings/later-texts.ts";

/** Texts for instructors and of what is handed in. */
export const { useThem: useTeachTexts, useThemSoon: useTeachTextsSoon } = laterTexts(loadCourseTeach);
