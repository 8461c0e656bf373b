import { at, type Pt } from "../kernel/geometry/point.ts";
import { diameter, toRadius } from "../kernel/units.ts";
import type { Task } from "./task.ts";
import { targetPart, type TargetPart, type TargetThread } from "./target-part.ts";

/**
 * A thread on a drawing: its stretch of the surface, the radius of its root (null where it varies), its name. Part
 * space, mm.
 */
export interface DrawnThread {
  readonly from: Pt;
  readonly to: Pt;
  readonly ground: number | null;
  readonly name: string;
}

/** The content of a task's workshop drawing. */
export interface DrawnTask extends TargetPart {
  readonly sizes: NonNullable<Task["sizes"]>;
  readonly threads: readonly DrawnThread[];
  readonly marks: NonNullable<Task["rules"]["rz"]>;
}

/** A thread of a part for the drawing. */
export function drawnThread({ from, to, crest, root, name }: TargetThread): DrawnThread {
  const [surface, ground] = [toRadius(diameter(crest)), toRadius(diameter(root))];
  return { from: at(from, surface), to: at(to, surface), ground, name };
}

/** The drawing of a task: its part with threads, sizes and marks; null without a part. */
export function drawnTask({ part, sizes, rules }: Pick<Task, "part" | "sizes" | "rules">): DrawnTask | null {
  if (!part) return null;
  return {
    ...targetPart(part),
    sizes: sizes ?? [],
    threads: (part.threads ?? []).map(drawnThread),
    marks: rules.rz ?? [],
  };
}
