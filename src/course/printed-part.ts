import { at, type Pt } from "../kernel/point.ts";
import type { Radius } from "../kernel/units.ts";
import { parse } from "../nc/parse.ts";
import { run } from "../program/run.ts";
import { shippedTools } from "../program/shipped-tools.ts";
import type { Task } from "./task.ts";
import { wantedPart, type WantedPart } from "./wanted-part.ts";

/** A thread that an answer cuts: where the surface that it is cut into begins and ends, its depth, nominal radius and lead. Part space, mm. */
export interface CutThread {
  readonly from: Pt;
  readonly to: Pt;
  readonly depth: number;
  readonly nominal: Radius;
  readonly lead: number;
  readonly starts: number;
}

/** What a workshop drawing of a task shows. */
export interface DrawnTask extends WantedPart {
  readonly sizes: NonNullable<Task["sizes"]>;
  readonly threads: readonly CutThread[];
  readonly marks: NonNullable<Task["rules"]["rz"]>;
}

/** Rapid rate for times, mm/min: none is asked for here. */
const RAPID = 10_000;

/** The threads of a program. */
function threadsOf(lines: readonly string[]): readonly CutThread[] {
  const { operations } = run(parse(`${lines.join("\n")}\n`), { tools: shippedTools, rapid: RAPID });
  return operations.flatMap(({ plan: { thread, contour }, start }) => {
    const points = contour.flatMap(({ from, to }) => [from, to]), [first, last] = [points[0], points.at(-1)];
    if (!thread || !first || !last) return [];
    // The contour of a thread has its teeth.
    const heights = points.map(({ r }) => r), [low, high] = [Math.min(...heights), Math.max(...heights)];
    const surface = start.r < low ? low : high;
    return [{
      from: at(first.z, surface),
      to: at(last.z, surface),
      depth: high - low,
      nominal: at(first.z, high).r,
      lead: thread.lead,
      starts: thread.starts,
    }];
  });
}

/** What is drawn of a task: its part with sizes and marks, and the threads of the stored answer; null where it has no part. */
export function drawnTask(task: Pick<Task, "part" | "sizes" | "rules" | "solution">): DrawnTask | null {
  if (!task.part) return null;
  return { ...wantedPart(task.part), sizes: task.sizes ?? [], threads: threadsOf(task.solution ?? []), marks: task.rules.rz ?? [] };
}
