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

/** A run on a playback, with the stock at any position. */
export interface PlayedScene extends PaintedRun {
  /** All blanks of the run: the stock never extends beyond them. */
  readonly blanks: readonly Ring[];
  /** The chip of the current cut; null if nothing is cut, and while the run is only planned. */
  readonly chipAt: (position: PlayPosition) => Chip | null;
  readonly playback: PlaybackStore;
}

/** The scene before a run: blank, tool and start point. */
export interface InitialScene {
  readonly blank: readonly Ring[];
  readonly tool: Tool | null;
  readonly start: Pt | null;
}

/** The step at a position; the last one at the end. */
export const stepIndex = (steps: readonly Step[], position: PlayPosition): number =>
  Math.min(position.step, steps.length - 1);

/**
 * The cuts that made the surfaces of a run, with the spindle for feeds per minute; `before`: those of a run that may
 * begin the same.
 */
export const surfacesOfRun = ({ steps, spindles }: Run, before: Surfaces = surfacesOf([])): Surfaces =>
  before.forRun(
    steps,
    (step) => spindleAt(spindles, step),
    (step) => turnsBack(spindles, step),
  );
