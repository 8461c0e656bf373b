import { z } from "zod/mini";
import { prediction } from "./task.ts";
import { inLanguages, words } from "./words.ts";

/*
 * A lesson is one file: a few pages, each with a text and an animation that the kernel computes from a program; an
 * example to edit; and the tasks that follow. The file contains its texts in all four languages.
 */

const lines = z.array(z.string().check(z.maxLength(200))).check(z.minLength(1), z.maxLength(400));

/** From a smaller number to a greater one. */
const span = z.tuple([z.number(), z.number()]);

const question = z.object({
  /** Its own name within the lesson: answers are stored by it, so it stays when pages move. */
  id: z.string().check(z.regex(/^[a-z0-9-]+$/)),
  /** As in a task: numbers and places have their right answer from a run; a choice and a block state it. */
  asks: prediction,
  /**
   * Lines that replace those of the program which begin with the same block number or parameter, for a question about
   * other values than the page shows. The picture shows them after the right answer.
   */
  with: z.optional(z.array(z.string().check(z.maxLength(200))).check(z.minLength(1))),
});

const page = z.object({
  /** The program of the animation; absent: that of the previous page. */
  program: z.optional(lines),
  /** The moves that are played, as blocks of the program ("from" to "to", inclusive); absent: all. */
  blocks: z.optional(z.object({ from: z.int(), to: z.int() })),
  /** State of the animation when the page opens: at "start", at "end", or playing. */
  begins: z._default(z.enum(["start", "end", "play"]), "play"),
  /** A parameter with a slider beside the text; the picture follows its value. */
  slide: z.optional(z.object({ q: z.string(), from: z.number(), to: z.number(), step: z.number() })),
  /** Visible section: from one ⌀ to another and from one Z to another, mm; absent: the blank and all feed moves. */
  frame: z.optional(z.object({ x: span, z: span })),
  /** What the picture shows in addition to path and stock. */
  shows: z.optional(z.enum(["residue", "roughness", "depth", "speed"])),
  /** A question about the page. It blocks nothing. */
  question: z.optional(question),
});

const questionWords = z.object({
  ask: words,
  /** The answers of a choice. */
  choices: z.optional(z.array(words).check(z.minLength(2), z.maxLength(4))),
  /** The reason, one for each choice; otherwise for the right answer and for a wrong one. */
  why: z.array(words).check(z.minLength(2), z.maxLength(4)),
});

const lessonWords = z.object({
  title: words,
  /** One sentence: what the learner can do after the lesson. */
  aim: words,
  /** One text for each page: a paragraph or two. */
  pages: z.array(words).check(z.minLength(1), z.maxLength(8)),
  /** One question for each page; null for a page without. */
  questions: z.array(z.nullable(questionWords)).check(z.maxLength(8)),
});

export const lessonSchema = z.object({
  id: z.string().check(z.regex(/^[a-z0-9-]+$/)),
  /** Order in the course, from 1. */
  number: z.int(),
  pages: z.array(page).check(z.minLength(1), z.maxLength(8)),
  /** A program that opens in the editor. */
  example: z.optional(lines),
  /**
   * Ids of its tasks, in order. An id never changes, even when the lesson number in it does: progress is stored by ids,
   * and nobody reads them.
   */
  tasks: z.array(z.string()),
  words: inLanguages(lessonWords),
});

export type Lesson = z.infer<typeof lessonSchema>;
export type PageQuestion = z.infer<typeof question>;
export type PageQuestionWords = z.infer<typeof questionWords>;
