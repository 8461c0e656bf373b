import type { Run } from "../../program/state/run-types.ts";

/** The tools of a run in the order of their first use, and the number of tool changes, the first tool included. */
export interface Uses {
  readonly tools: readonly number[];
  readonly changes: number;
}

export function usesOf({ steps }: Pick<Run, "steps">): Uses {
  const tools = new Set<number>();
  let [changes, last] = [0, NaN];
  for (const { tool } of steps) {
    if (tool.T !== last) changes += 1;
    last = tool.T;
    tools.add(last);
  }
  return { tools: [...tools], changes };
}
