import { readResult, RESULT_FORMAT, type HandedResult } from "../../../course/made/result.ts";
import { formatOf, readSet, readTask } from "../../../course/read-task.ts";
import { SET_FORMAT, type TaskSet } from "../../../course/task-set.ts";
import type { CourseFileProblem } from "../../../app/records/course/opened-course-file.ts";
import { TASK_FORMAT, type Task } from "../../../course/task.ts";
import { packedForLink, unpackedFromLink } from "../../../app/records/link.ts";
import { fromOutside } from "../../../app/records/course/content.ts";

/** Prefixes with versions of the links; newer ones have higher numbers. */
const TASK_MARK = "#t1=",
  SET_MARK = "#s1=",
  RESULT_MARK = "#r1=";
/** Largest file of a task or of results, and longest unpacked text of a link, characters. */
export const LARGEST_TAUGHT = 4_000_000;

/** The content, or why there is none. `left`: unknown fields. */
export type ReadTaught =
  | { readonly kind: "task"; readonly task: Task; readonly left: readonly string[] }
  | { readonly kind: "set"; readonly set: TaskSet; readonly left: readonly string[] }
  | { readonly kind: "result"; readonly result: HandedResult }
  | CourseFileProblem;

/** Links with a task, a set, or results. `page`: the address without the fragment. */
export const taskLink = (page: string, task: Task): string => page + TASK_MARK + packedForLink(task);
export const setLink = (page: string, set: TaskSet): string => page + SET_MARK + packedForLink(set);
export const resultLink = (page: string, result: HandedResult): string => page + RESULT_MARK + packedForLink(result);

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
    return { raw: JSON.parse(plain) as unknown };
  } catch (error) {
    return { kind: "notJson", line: lineOf(error, plain) };
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
export function readTaughtLink(hash: string, most = LARGEST_TAUGHT): ReadTaught {
  const [mark, form] = /^#[trs](\d+)=/.exec(hash) ?? [];
  if (mark === undefined) return { kind: "damaged" };
  if (Number(form) > 1) return { kind: "newer" };
  try {
    const text = unpackedFromLink(hash.slice(mark.length), most);
    if (text === null) return { kind: "tooLarge" };
    const read = readTaught(text);
    // The packed text was valid JSON: invalid text was truncated or altered on its way.
    return read.kind === "notJson" || read.kind === "foreign" ? { kind: "damaged" } : read;
  } catch {
    return { kind: "damaged" };
  }
}
