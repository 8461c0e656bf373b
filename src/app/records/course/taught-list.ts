import { z } from "zod/mini";
import { taskSchema, type Task } from "../../../course/task.ts";

/** Most tasks that are kept. */
export const MOST_TAUGHT = 200;
const kept = z.object({ version: z.literal(1), tasks: z.array(taskSchema).check(z.maxLength(MOST_TAUGHT)) });

/** The text that is kept; null where there is none. */
export const writeTaught = (tasks: readonly Task[]): string | null => (tasks.length === 0 ? null : JSON.stringify({ version: 1, tasks }));

/** Kept tasks; null where they are damaged. Never throws. */
export function readTaughtList(text: string): readonly Task[] | null {
  try {
    const read = kept.safeParse(JSON.parse(text));
    return read.success ? read.data.tasks : null;
  } catch {
    return null;
  }
}
