import { z } from "zod/mini";
import { moment } from "../program/files/bounded.ts";
import type { LessonLanguage } from "../i18n/languages.ts";
import { progressOfTask, type CourseProgress } from "./progress.ts";
import { taskSchema, type Task } from "./task.ts";
import { inLanguages, shownLanguageOf, words, type InLanguages } from "./words.ts";

/*
 * Several tasks in order, under one title, as one file or link. The instructor keeps the whole set; learners get it
 * without what they must not read. docs/tasks.md describes it.
 */

export const SET_FORMAT = "turnwise-set/1";

/** Most tasks of a set; longest exam, minutes; most checks of an exam task. */
export const SET_LIMITS = { tasks: 30, minutes: 1440, tries: 99 } as const;

/** What an exam says after a check: nothing, and there is none; passed or not; how many goals are met. */
export const EXAM_REPORTS = ["nothing", "passed", "goals"] as const;

const exam = z.object({
  /** Minutes from the start until it ends; absent: no limit. */
  minutes: z.optional(z.int().check(z.gte(1), z.lte(SET_LIMITS.minutes))),
  /** Checks of each task; absent: no limit. */
  tries: z.optional(z.int().check(z.gte(1), z.lte(SET_LIMITS.tries))),
  reports: z.enum(EXAM_REPORTS),
  /** It can be begun and handed in without a name. */
  anonymous: z.optional(z.boolean()),
});

/** What learners get besides the assignment: hints and solution, hints alone, or neither. */
export const SET_HELP = ["all", "hints", "none"] as const;

export const setSchema = z.object({
  format: z.literal(SET_FORMAT),
  id: z.string().check(z.regex(/^[a-z0-9][a-z0-9-]{1,60}$/)),
  words: inLanguages(z.object({ title: words, about: z.optional(words) })),
  tasks: z.array(taskSchema).check(z.maxLength(SET_LIMITS.tasks)),
  /** Until when it is to be handed in, ms since 1970. */
  due: z.optional(moment),
  help: z._default(z.enum(SET_HELP), "all"),
  exam: z.optional(exam),
});
export type TaskSet = z.infer<typeof setSchema>;

/** A task without its solution and its wrong answers, and without hints unless `hints`. */
export function withoutAnswer({ solution: _, wrong: __, ...task }: Task, hints: boolean): Task {
  if (hints) return task;
  const told = Object.entries(task.words).map(([language, said]) => [language, said && { ...said, hints: [] }]);
  return { ...task, words: Object.fromEntries(told) as Task["words"] };
}

/** A task of an exam: nor does it say which choice or block is right, or what was learned. */
function examTask(task: Task): Task {
  const { words: said, predict, variants: _, ...bare } = withoutAnswer(task, false);
  const told = Object.entries(said).map(([language, each]) => {
    if (!each) return [language, each];
    const { learned: __, ...rest } = each;
    return [language, rest];
  });
  return {
    ...bare,
    ...(predict && {
      predict: predict.map((each) => {
        if (each.ask !== "choice" && each.ask !== "block") return each;
        const { right: __, ...asked } = each;
        return asked;
      }),
    }),
    words: Object.fromEntries(told) as Task["words"],
  };
}

/** The set as learners get it: the parts that they must not read are not in it at all. */
export const setForLearners = (set: TaskSet): TaskSet => {
  const { exam: terms, help } = set;
  if (terms) return { ...set, help: "none", tasks: set.tasks.map(examTask) };
  return help === "all" ? set : { ...set, tasks: set.tasks.map((task) => withoutAnswer(task, help === "hints")) };
};

/** Whether a set is as learners get it: a task that makes something lacks its answer. */
export const isForLearners = ({ tasks }: TaskSet): boolean =>
  tasks.some(({ kind, solution, predict = [] }) =>
    kind === "predict"
      ? predict.some((each) => (each.ask === "choice" || each.ask === "block") && each.right === undefined)
      : solution === undefined,
  );

/** The part of a set's id that ends the ids of its tasks. */
export const markOfSet = (id: string): string => id.slice(id.lastIndexOf("-") + 1);

/** Longest id of a task that leaves room for the mark of its set. */
const LONGEST_STEM = 48;

/**
 * A task as part of a set, with an id of its own: progress of the same task outside the set, or in another one, does not
 * count.
 */
export const taskInSet = (task: Task, mark: string): Task => ({
  ...task,
  id: task.id.endsWith(`-${mark}`) ? task.id : `${task.id.slice(0, LONGEST_STEM)}-${mark}`,
});

/** A set with the texts of one language alone, where they are: much shorter, so that it fits a QR code. */
export function setInLanguage(set: TaskSet, language: LessonLanguage): TaskSet {
  const only = <T>(words: InLanguages<T>): InLanguages<T> => {
    const shown = shownLanguageOf(words, language);
    return shown ? { [shown]: words[shown] } : words;
  };
  return {
    ...set,
    words: only(set.words) as TaskSet["words"],
    tasks: set.tasks.map((task) => ({ ...task, words: only(task.words) as Task["words"] })),
  };
}

/** The next task of a set that is not passed, after one of its tasks or from the beginning; null once all are. */
export function nextOpenTask({ tasks }: TaskSet, progress: CourseProgress, after: string): Task | null {
  const at = tasks.findIndex(({ id }) => id === after) + 1;
  const inOrder = [...tasks.slice(at), ...tasks.slice(0, at)];
  return inOrder.find(({ id }) => id !== after && progressOfTask(progress, id).passed === null) ?? null;
}
