import { z } from "zod/mini";
import { LESSON_LANGUAGES, type Language, type LessonLanguage } from "../i18n/languages.ts";

/** Longest text of a lesson or a task, characters. */
const LONGEST = 2000;
export const words = z.string().check(z.minLength(1), z.maxLength(LONGEST));

/** A value by lesson language; shipped content has all of them, an instructor's at least one. */
export type InLanguages<T> = Readonly<Partial<Record<LessonLanguage, T | undefined>>>;

/** Its schema. */
export const inLanguages = <S extends z.core.$ZodType>(schema: S) =>
  z.object(
    Object.fromEntries(LESSON_LANGUAGES.map((each) => [each, z.optional(schema)])) as Record<
      LessonLanguage,
      z.ZodMiniOptional<S>
    >,
  );

/**
 * The language in which a value is shown: the screen language if available, else the first one that is; undefined
 * without any.
 */
export const shownLanguageOf = (said: InLanguages<unknown>, screen: Language): LessonLanguage | undefined =>
  [screen, ...LESSON_LANGUAGES].find((each): each is LessonLanguage => said[each as LessonLanguage] !== undefined);

/** The value in that language. */
export function inScreenLanguage<T>(said: InLanguages<T>, screen: Language): T | undefined {
  const language = shownLanguageOf(said, screen);
  return language && said[language];
}
