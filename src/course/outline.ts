import { z } from "zod/mini";
import { inLanguages, words } from "./words.ts";

/*
 * The outline of the course is one file, src/course/outline.json: its chapters, and the paths through it besides the
 * whole course. It contains its texts in all four languages.
 */

const id = z.string().check(z.regex(/^[a-z0-9-]+$/));

/** Lessons of one subject, in the order of the course. */
const chapter = z.object({ id, lessons: z.array(id), words: inLanguages(z.object({ title: words })) });

/** A path: some lessons, each with some of its exercises. Progress stores its id. */
const path = z.object({
  id,
  lessons: z.array(z.object({ lesson: id, tasks: z.array(id) })),
  words: inLanguages(z.object({ title: words, about: words })),
});

export const outlineSchema = z.object({ chapters: z.array(chapter), paths: z.array(path) });
export type Outline = z.infer<typeof outlineSchema>;
export type CoursePath = Pick<Outline["paths"][number], "id" | "lessons">;
