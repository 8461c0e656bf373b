/* oxlint-disable typescript/consistent-type-imports -- A declared module cannot import from a file beside it. */
/**
 * Generated from the files of lessons and tasks (scripts/course-index.ts), so that the lesson list need not load them.
 */
declare module "virtual:course-index" {
  /** The number of each lesson, by its id. */
  export const lessonNumbers: Readonly<Partial<Record<string, number>>>;
  /** All lessons in their order, in a language. */
  export function courseIndexOf(
    language: import("../../../i18n/languages.ts").Language,
  ): Promise<import("./content.ts").CourseIndex>;
}
