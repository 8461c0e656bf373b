import { z } from "zod/mini";
import { inLanguages, words } from "./words.ts";

/*
 * A lesson is one file: a few pages, each a text beside a moving picture that the kernel makes from a program; an
 * example to play with; and the tasks that follow. Its words stand in it in the four languages.
 */

const lines = z.array(z.string().check(z.maxLength(200))).check(z.minLength(1), z.maxLength(400));

/** From a smaller number to a greater one. */
const span = z.tuple([z.number(), z.number()]);

const page = z.object({
  /** The program whose run is the picture; absent: that of the page before. */
  program: z.optional(lines),
  /** Which moves are played, as blocks of the program ("from" to "to", both included); absent: all. */
  blocks: z.optional(z.object({ from: z.int(), to: z.int() })),
  /** Where it stands when the page opens: "start", "end", or playing at once. */
  begins: z._default(z.enum(["start", "end", "play"]), "play"),
  /** A value that the learner may slide beside the text: the picture follows. */
  slide: z.optional(z.object({ q: z.string(), from: z.number(), to: z.number(), step: z.number() })),
  /**
   * What of the lathe is seen: from one ⌀ to another and from one Z to another, mm; absent: the blank with all that is
   * fed.
   */
  frame: z.optional(z.object({ x: span, z: span })),
  /** What the picture is drawn with beside path and stock. */
  shows: z.optional(z.enum(["residue", "roughness", "depth", "speed"])),
});

const told = z.object({
  title: words,
  /** One sentence: what one can do afterwards. */
  aim: words,
  /** One text for each page: a paragraph or two. */
  pages: z.array(words).check(z.minLength(1), z.maxLength(8)),
});

export const lessonSchema = z.object({
  id: z.string().check(z.regex(/^[a-z0-9-]+$/)),
  /** Order in the course, from 1. */
  number: z.int(),
  pages: z.array(page).check(z.minLength(1), z.maxLength(8)),
  /** A program that is opened in the editor to play with. */
  example: z.optional(lines),
  /**
   * Ids of its tasks, in order. They stay where a lesson moves, the number in them too: progress is kept by them, and
   * nobody reads it.
   */
  tasks: z.array(z.string()),
  words: inLanguages(told),
});

export type Lesson = z.infer<typeof lessonSchema>;
