import { z } from "zod/mini";

/** How long a task was open and visible, ms, and how many changes were made in it. */
export interface Worked {
  readonly ms: number;
  readonly steps: number;
}
export type WorkedTasks = Readonly<Record<string, Worked>>;

const shape = z.object({
  version: z.literal(1),
  tasks: z.record(z.string().check(z.maxLength(100)), z.object({ ms: z.number(), steps: z.int() })),
});

export function readWorked(text: string): WorkedTasks | null {
  try {
    const read = shape.safeParse(JSON.parse(text));
    return read.success ? read.data.tasks : null;
  } catch {
    return null;
  }
}

export const writeWorked = (list: WorkedTasks): string | null =>
  Object.keys(list).length === 0 ? null : JSON.stringify({ version: 1, tasks: list });

/** What was worked here and elsewhere: the same work may stand in both, so the more counts. */
export function mergedWorked(mine: WorkedTasks, brought: WorkedTasks): WorkedTasks {
  const all = { ...mine };
  for (const [id, { ms, steps }] of Object.entries(brought)) {
    const here = Object.hasOwn(mine, id) ? mine[id] : undefined;
    all[id] = { ms: Math.max(here?.ms ?? 0, ms), steps: Math.max(here?.steps ?? 0, steps) };
  }
  return all;
}
