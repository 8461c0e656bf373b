import type { Shape } from "../shape.ts";

/** The command palette. */
export const commands = {
  title: "Commands",
  search: "Search commands, cycles, pages",
  none: "Nothing found.",
  count: (n: number) => (n === 1 ? "1 command" : `${n} commands`),
  start: "Start page",
  course: "Course",
  guide: "Guide",
  glossary: "Glossary",
  groups: {
    recent: "Recently used",
    action: "Actions",
    page: "Pages",
    program: "Programs",
    cycle: "Cycles",
    lesson: "Lessons",
    example: "Examples",
    setting: "Settings",
  },
  kinds: {
    action: "Action",
    page: "Page",
    program: "Program",
    cycle: "Cycle",
    lesson: "Lesson",
    example: "Example",
    setting: "Setting",
  },
};

export type CommandsTexts = Shape<typeof commands>;
