import type { Pt, Ring } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Chip } from "../../sim/chip/chip.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { Run } from "../../program/state/run-types.ts";
import { spindleAt, turnsBack } from "../../sim/load/spindles.ts";
import type { PaintedRun } from "../../view/material/stock-painter.ts";
import { surfacesOf, type Surfaces } from "../../view/material/surfaces.ts";
import type { PlaybackStore } from "./playback-store.ts";

/** What moves in the picture: a run on a playback, and the stock at any position of it. */
export interface Moving extends PaintedRun {
  /** All that stands there at some moment before it is cut: nothing ever stands beyond it. */
  readonly blanks: readonly Ring[];
  /** What the running cut takes off; null where it takes nothing, and as long as the run is only planned. */
  readonly chipAt: (position: PlayPosition) => Chip | null;
  readonly playback: PlaybackStore;
}

/** What stands there before anything moves. */
export interface Waiting {
  readonly blank: readonly Ring[];
  readonly tool: Tool | null;
  readonly start: Pt | null;
}

/** The step that runs at a position; the last one at the end. */
export const stepIndex = (steps: readonly Step[], position: PlayPosition): number =>
  Math.min(position.step, steps.length - 1);

/**
 * What made the surfaces of a run, with its spindle for feeds per minute; `before`: those of a run that may begin as it
 * does.
 */
export const surfacesOfRun = ({ steps, spindles }: Run, before: Surfaces = surfacesOf([])): Surfaces =>
  before.again(
    steps,
    (step) => spindleAt(spindles, step),
    (step) => turnsBack(spindles, step),
  );
