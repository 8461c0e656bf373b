/* eslint-disable @typescript-eslint/consistent-type-imports -- A declared module cannot import from a file beside it. */
/**
 * Made by the build out of the files of lessons and tasks (scripts/course-index.ts): the list of lessons waits for none
 * of them.
 */
declare module "virtual:course-index" {
  /** The number of each lesson, by its id. */
  export const lessonNumbers: Readonly<Partial<Record<string, number>>>;
  /** All lessons in their order, in a language. */
  export function courseIndexOf(
    language: import("../../../i18n/languages.ts").Language,
  ): Promise<import("./content.ts").CourseIndex>;
}
