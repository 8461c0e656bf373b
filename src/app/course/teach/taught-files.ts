import { readResult, RESULT_FORMAT, type HandedResult } from "../../../course/made/result.ts";
import { TASK_FORMAT, taskSchema, type Task } from "../../../course/task.ts";
import { packedForLink, unpackedFromLink } from "../../handing/link.ts";

/** Forms of the links; newer ones have higher numbers. */
const TASK_MARK = "#t1=", RESULT_MARK = "#r1=";
/** Largest file of a task or of results, and most text that a link unpacks to, characters. */
export const LARGEST_TAUGHT = 4_000_000;

/** What was read, or why nothing was. */
export type ReadTaught = { readonly kind: "task"; readonly task: Task } | { readonly kind: "result"; readonly result: HandedResult } | {
  readonly kind: "tooLarge" | "newer" | "damaged";
};

/** Links that carry a task, or results. `page`: the address without anything behind `#`. */
export const taskLink = (page: string, task: Task): string => page + TASK_MARK + packedForLink(task);
export const resultLink = (page: string, result: HandedResult): string => page + RESULT_MARK + packedForLink(result);

/** The same as files. */
export const taughtFile = (content: Task | HandedResult): string => `${JSON.stringify(content, null, 1)}\n`;

/** A format of this product with a higher number than the one that is read here. */
function isNewer(format: unknown): boolean {
  const [name, number] = typeof format === "string" ? format.split("/") : [];
  return [TASK_FORMAT, RESULT_FORMAT].some((known) => known.split("/")[0] === name && Number(number) > Number(known.split("/")[1]));
}

/** Reads the text of a task or of results. Never throws. */
export function readTaught(text: string): ReadTaught {
  if (text.length > LARGEST_TAUGHT) return { kind: "tooLarge" };
  try {
    const raw: unknown = JSON.parse(text);
    const format = typeof raw === "object" && raw !== null && "format" in raw ? raw.format : null;
    if (isNewer(format)) return { kind: "newer" };
    if (format === RESULT_FORMAT) {
      const result = readResult(raw);
      return result ? { kind: "result", result } : { kind: "damaged" };
    }
    const read = taskSchema.safeParse(raw);
    return read.success && Object.keys(read.data.words).length > 0 ? { kind: "task", task: read.data } : { kind: "damaged" };
  } catch {
    return { kind: "damaged" };
  }
}

/** Reads the part of a link behind `#`. Never throws, and never unpacks more than it opens. */
export function readTaughtLink(hash: string, most = LARGEST_TAUGHT): ReadTaught {
  const [mark, form] = /^#[tr](\d+)=/.exec(hash) ?? [];
  if (mark === undefined) return { kind: "damaged" };
  if (Number(form) > 1) return { kind: "newer" };
  try {
    const text = unpackedFromLink(hash.slice(mark.length), most);
    return text === null ? { kind: "tooLarge" } : readTaught(text);
  } catch {
    return { kind: "damaged" };
  }
}
