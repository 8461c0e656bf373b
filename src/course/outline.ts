/*
 * The outline of the course: its chapters, and the paths through it besides the whole course. Titles are texts of the
 * screen (i18n, `course`), by the ids below.
 */

/** Lessons of one subject, in the order of the course. */
export interface Chapter {
  readonly id: string;
  readonly lessons: readonly string[];
}

export const CHAPTERS = [
  { id: "basics", lessons: ["axes", "tool", "first-shoulder", "speed"] },
  { id: "shoulders", lessons: ["shoulder-812-edges", "shoulder-812-angles", "finishing", "build-812"] },
  { id: "contours", lessons: ["contour", "build-820", "recess-turning", "build-852"] },
  { id: "features", lessons: ["direction", "valleys", "recessing", "threads", "bores-and-holders"] },
  {
    id: "programs",
    lessons: ["approach-and-departure", "reading-foreign-programs", "faults", "cutting-data", "from-a-drawing"],
  },
] as const satisfies readonly Chapter[];
export type ChapterId = (typeof CHAPTERS)[number]["id"];

/** A path: some lessons, each with some of its exercises. */
export interface CoursePath {
  readonly id: string;
  readonly lessons: readonly { readonly lesson: string; readonly tasks: readonly string[] }[];
}

export const PATHS = [
  {
    id: "hour",
    lessons: [
      { lesson: "first-shoulder", tasks: ["l03-first-shoulder", "l03-how-many-passes"] },
      { lesson: "build-812", tasks: ["l08-set-up", "l08-cycle-values"] },
      { lesson: "contour", tasks: ["l09-lost-contour", "l09-cap-contour"] },
      { lesson: "build-820", tasks: ["l12-820-contour", "l12-820-values"] },
      { lesson: "recess-turning", tasks: ["l13-seal-groove", "l13-careful-setter"] },
      { lesson: "build-852", tasks: ["l14-852-values", "l14-series"] },
    ],
  },
] as const satisfies readonly CoursePath[];
export type PathId = (typeof PATHS)[number]["id"];
