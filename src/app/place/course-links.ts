import type { LessonPage } from "../../course/progress.ts";
import { printAddress } from "./address.ts";

/** Address of the list of lessons, or of a page of a lesson. A link, so that Back and Forward work. */
export const courseHref = (lesson: string | null = null, at: LessonPage = 1): string =>
  printAddress({ page: "course", lesson, at });
