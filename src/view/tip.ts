import { part, type Pt } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import { pathOf } from "../kernel/time/time.ts";
import type { PlayPosition } from "../sim/simulation.ts";

/** The tip at a position of a run, on its line or arc; null in an empty run. */
export function tipAt(steps: readonly Step[], position: PlayPosition): Pt | null {
  const running = steps[position.step];
  if (running) return part.pointOn(pathOf(running.from, running.move), position.fraction);
  return steps.at(-1)?.move.to ?? null;
}
