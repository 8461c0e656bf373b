import { z } from "zod/mini";

/** Longest text of a lesson or a task, characters. */
const LONGEST = 2000;
export const words = z.string().check(z.minLength(1), z.maxLength(LONGEST));

/**
 * A schema in the languages of the screen. Lessons and tasks that ship with the page have all of them; a task of an instructor has one at
 * least, and what is missing is shown in one that is there.
 */
export const inLanguages = <S extends z.core.$ZodType>(schema: S) =>
  z.object({ en: z.optional(schema), de: z.optional(schema), fr: z.optional(schema), zh: z.optional(schema) });
