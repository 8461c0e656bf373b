import type { LessonPage } from "../../course/progress.ts";
import { hideCourse, useCoursePlace } from "../place/course-place.ts";
import { hideGuide } from "../place/guide-place.ts";
import { hideOwn } from "./own-place.ts";
import { usePlace } from "../place/place.ts";
import { open, useEditor } from "./store.ts";
import { hideTools } from "./tool-place.ts";
import { showElsewhere } from "../place/elsewhere.ts";
import { hideWhich } from "./which-place.ts";
import { hideWorks, useWorksPlace } from "../place/works-place.ts";

/** Leaves every page that stands over the work, so that the work is what is seen. */
export function showOpenWork(): void {
  hideGuide();
  hideTools();
  hideOwn();
  hideWhich();
}

/** Shows the start page. What was open stays on the device, and undo opens it again. */
export function goHome(): void {
  showOpenWork();
  hideWorks();
  hideCourse();
  showElsewhere(null);
  usePlace.setState({ section: "prompts", prompt: null, field: null });
  if (useEditor.getState().work !== null) open(null, null);
}

/** Shows the list of all works, in place of the start page. */
export function goToWorks(): void {
  goHome();
  useWorksPlace.setState({ shown: true });
}

/** Shows the course in place of the start page: the list of its lessons, or a page of one. */
export function goToCourse(lesson: string | null = null, page: LessonPage = 1): void {
  goHome();
  useCoursePlace.setState({ shown: true, lesson, page });
}
