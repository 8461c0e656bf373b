import { readJson } from "../../../program/files/bounded.ts";
import { readResult, RESULT_FORMAT, type HandedResult } from "../../../course/made/result.ts";
import { formatOf, readSet, readTask } from "../../../course/read-task.ts";
import { markOfSet, SET_FORMAT, setForLearners, taskInSet, type TaskSet } from "../../../course/task-set.ts";
import type { CourseFileProblem } from "../../../app/records/course/opened-course-file.ts";
import { TASK_FORMAT, type Task } from "../../../course/task.ts";
import { packedForLink, unpackedFromLink } from "../../../app/records/link.ts";
import { fetchTask, fromOutside } from "../../../app/records/course/content.ts";
import { TAUGHT_DICTIONARY } from "./taught-dictionary.ts";

/** Form of the links; newer ones have higher numbers. The first one was packed like a work. */
const LINK_FORM = 2;
const linkTo = (page: string, kind: "t" | "s" | "r", content: unknown): string =>
  `${page}#${kind}${LINK_FORM}=${packedForLink(content, TAUGHT_DICTIONARY)}`;
/** Largest file of a task or of results, and longest unpacked text of a link, characters. */
export const LARGEST_TAUGHT = 4_000_000;

/** The content, or why there is none. `left`: unknown fields. */
export type ReadTaught =
  | { readonly kind: "task"; readonly task: Task; readonly left: readonly string[] }
  | { readonly kind: "set"; readonly set: TaskSet; readonly left: readonly string[] }
  | { readonly kind: "result"; readonly result: HandedResult }
  | CourseFileProblem;

/** Links with a task, a set, or results. `page`: the address without the fragment. */
export const taskLink = (page: string, task: Task): string => linkTo(page, "t", task);
export const resultLink = (page: string, result: HandedResult): string => linkTo(page, "r", result);

/** The tasks of a set that are those of the course, unchanged: their ids in the course by their ids in the set. */
export async function courseTasksIn({
  id,
  tasks,
}: Pick<TaskSet, "id" | "tasks">): Promise<ReadonlyMap<string, string>> {
  const mark = markOfSet(id);
  const ids = await Promise.all(
    tasks.map(async (task) => {
      const name = task.id.endsWith(`-${mark}`) ? task.id.slice(0, -mark.length - 1) : task.id;
      const own = await fetchTask(name);
      return own && JSON.stringify(taskInSet(own, mark)) === JSON.stringify(task) ? ([task.id, name] as const) : null;
    }),
  );
  return new Map(ids.filter((each) => each !== null));
}

/** A link with a set for learners. A task of the course is named only, since every page has the course. */
export const setLink = (page: string, set: TaskSet, ofCourse: ReadonlyMap<string, string>): string =>
  linkTo(page, "s", {
    ...set,
    tasks: set.tasks.map((task) => {
      const course = ofCourse.get(task.id);
      return course === undefined ? task : { course };
    }),
  });

const isObject = (raw: unknown): raw is Readonly<Record<string, unknown>> => typeof raw === "object" && raw !== null;

/** A set of a link with the tasks that it only names; null if this page has no such task, as a newer one may. */
async function withCourseTasks(text: string): Promise<string | null> {
  const raw = readJson(text);
  if (!isObject(raw) || raw["format"] !== SET_FORMAT || !Array.isArray(raw["tasks"])) return text;
  const mark = markOfSet(String(raw["id"]));
  const tasks: unknown[] = [];
  for (const each of raw["tasks"]) {
    const name: unknown = isObject(each) ? each["course"] : undefined;
    const task = typeof name === "string" ? await fetchTask(name) : null;
    if (name !== undefined && !task) return null;
    tasks.push(task ? taskInSet(task, mark) : each);
  }
  return JSON.stringify({ ...raw, tasks });
}

/** A task, a set or results as a file. */
export const taughtFile = (content: Task | TaskSet | HandedResult): string => `${JSON.stringify(content, null, 1)}\n`;

/** A format of this product with a higher version than this page reads. */
function isNewer(format: unknown): boolean {
  const [name, number] = typeof format === "string" ? format.split("/") : [];
  return [TASK_FORMAT, SET_FORMAT, RESULT_FORMAT].some(
    (known) => known.split("/")[0] === name && Number(number) > Number(known.split("/")[1]),
  );
}

const BOM = /^\uFEFF/;

/** The line in which JSON syntax breaks, if the browser reports it. */
function lineOf(error: unknown, text: string): number | null {
  const said = error instanceof Error ? error.message : "";
  const [, line] = /\bline (\d+)/.exec(said) ?? [],
    [, position] = /\bposition (\d+)/.exec(said) ?? [];
  if (line !== undefined) return Number(line);
  return position === undefined ? null : text.slice(0, Number(position)).split("\n").length;
}

/** The JSON value of a text. */
function parsed(text: string): { readonly raw: unknown } | CourseFileProblem {
  const plain = text.replace(BOM, "");
  try {
    return { raw: readJson(plain) };
  } catch (error) {
    return error instanceof SyntaxError ? { kind: "notJson", line: lineOf(error, plain) } : { kind: "foreign" };
  }
}

/** Reads the text of a task, a set or results. Never throws. */
export function readTaught(text: string): ReadTaught {
  if (text.length > LARGEST_TAUGHT) return { kind: "tooLarge" };
  const found = parsed(text);
  if (!("raw" in found)) return found;
  const { raw } = found,
    format = formatOf(raw);
  if (isNewer(format)) return { kind: "newer" };
  if (format === RESULT_FORMAT) {
    const result = readResult(raw);
    return result ? { kind: "result", result } : { kind: "damaged" };
  }
  if (format === SET_FORMAT) {
    const read = readSet(raw);
    return "set" in read ? { kind: "set", ...read } : { kind: "fields", ...read };
  }
  if (format !== TASK_FORMAT) return { kind: "foreign" };
  const read = readTask(raw);
  return "task" in read ? { kind: "task", task: fromOutside(read.task), left: read.left } : { kind: "fields", ...read };
}

/** Whether a text that claims to be JSON contains a task, a set, or results. */
export const isTaughtText = (text: string): boolean =>
  /^\uFEFF?\s*\{/.test(text) && /"format"\s*:\s*"turnwise-(?:task|set|result)\//.test(text);

/** Reads the fragment of a link. Never throws, and never unpacks more than its limit. */
export async function readTaughtLink(hash: string, most = LARGEST_TAUGHT): Promise<ReadTaught> {
  const [mark, form] = /^#[trs](\d+)=/.exec(hash) ?? [];
  if (mark === undefined) return { kind: "damaged" };
  if (Number(form) > LINK_FORM) return { kind: "newer" };
  try {
    const packed = hash.slice(mark.length);
    const text = form === "1" ? unpackedFromLink(packed, most) : unpackedFromLink(packed, most, TAUGHT_DICTIONARY);
    if (text === null) return { kind: "tooLarge" };
    const whole = await withCourseTasks(text);
    if (whole === null) return { kind: "newer" };
    const read = readTaught(whole);
    // The packed text was valid JSON: invalid text was truncated or altered on its way.
    if (read.kind === "notJson" || read.kind === "foreign") return { kind: "damaged" };
    return read.kind === "set" ? { ...read, set: setForLearners(read.set) } : read;
  } catch {
    return { kind: "damaged" };
  }
}
