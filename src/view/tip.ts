import type { Pt } from "../kernel/point.ts";
import type { Step } from "../kernel/step.ts";
import { axial, radius } from "../kernel/units.ts";
import type { Position } from "./playback.ts";

/** Where the tip stands when a fraction (0 to 1) of a step is done: on its line or its arc. */
export function alongStep(step: Step, fraction: number): Pt {
  const { from, move } = step, f = Math.min(1, Math.max(0, fraction));
  if (f === 0) return from;
  if (f === 1) return move.to;
  if (move.kind !== "arc") {
    return { z: axial(from.z + (move.to.z - from.z) * f), r: radius(from.r + (move.to.r - from.r) * f) };
  }
  const { centre } = move, size = Math.hypot(from.z - centre.z, from.r - centre.r);
  const begin = Math.atan2(from.r - centre.r, from.z - centre.z);
  const end = Math.atan2(move.to.r - centre.r, move.to.z - centre.z);
  const whole = 2 * Math.PI, way = move.turn === "ccw" ? 1 : -1;
  const sweep = ((((end - begin) * way) % whole) + whole) % whole || whole;
  const angle = begin + way * sweep * f;
  return { z: axial(centre.z + size * Math.cos(angle)), r: radius(centre.r + size * Math.sin(angle)) };
}

/** The tip at a position of a run, or null in an empty run. */
export function tipAt(steps: readonly Step[], position: Position): Pt | null {
  const running = steps[position.step];
  if (running) return alongStep(running, position.fraction);
  return steps.at(-1)?.move.to ?? null;
}
