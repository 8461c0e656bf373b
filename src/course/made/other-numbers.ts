import { z } from "zod/mini";

const text = z.string().check(z.maxLength(500));

/**
 * Other numbers in the program of a task of predictions: its lines, the numbers that its words name, from and to, and
 * the tries before.
 */
export const otherNumbers = z.object({
  lines: z.readonly(z.array(text).check(z.maxLength(2000))),
  named: z.readonly(z.array(z.readonly(z.tuple([text, text]))).check(z.maxLength(60))),
  at: z._default(z.int(), 0),
});
/** The questions that are asked again, from 0. */
export const askedQuestions = z.readonly(z.array(z.int()).check(z.maxLength(60)));
