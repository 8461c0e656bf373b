import { loadCourseDrawing } from "../../../i18n/load-course-drawing.ts";
import { laterTexts } from "../../../app/base/settings/later-texts.ts";

/** Texts of workshop drawings. */
export const { useThem: useDrawingTexts } = laterTexts(loadCourseDrawing);
