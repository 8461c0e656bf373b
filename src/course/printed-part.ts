import { at, type Pt } from "../kernel/geometry/point.ts";
import { diameter, toRadius } from "../kernel/units.ts";
import type { Task } from "./task.ts";
import { wantedPart, type WantedPart, type WantedThread } from "./wanted-part.ts";

/**
 * A thread as it is drawn: its stretch of the surface, the radius of its ground (null where it has no one), its name.
 * Part space, mm.
 */
export interface DrawnThread {
  readonly from: Pt;
  readonly to: Pt;
  readonly ground: number | null;
  readonly name: string;
}

/** What a workshop drawing of a task shows. */
export interface DrawnTask extends WantedPart {
  readonly sizes: NonNullable<Task["sizes"]>;
  readonly threads: readonly DrawnThread[];
  readonly marks: NonNullable<Task["rules"]["rz"]>;
}

/** A thread of a part as it is drawn. */
export function drawnThread({ from, to, crest, root, name }: WantedThread): DrawnThread {
  const [surface, ground] = [toRadius(diameter(crest)), toRadius(diameter(root))];
  return { from: at(from, surface), to: at(to, surface), ground, name };
}

/** What is drawn of a task: its part with threads, sizes and marks; null where it has no part. */
export function drawnTask({ part, sizes, rules }: Pick<Task, "part" | "sizes" | "rules">): DrawnTask | null {
  if (!part) return null;
  return {
    ...wantedPart(part),
    sizes: sizes ?? [],
    threads: (part.threads ?? []).map(drawnThread),
    marks: rules.rz ?? [],
  };
}
