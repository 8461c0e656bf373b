import type { LessonPage } from "../../course/progress.ts";
import { printAddress } from "./address.ts";

/**
 * Address of the list of lessons, or of a page of one: what links lead to, so that Back and Forward go from page to
 * page.
 */
export const courseHref = (lesson: string | null = null, at: LessonPage = 1): string =>
  printAddress({ page: "course", lesson, at });
