import type { Step } from "../../kernel/time/step.ts";
import { pathOf, travelOf } from "../../kernel/time/time.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { StepPiece } from "./step-pieces.ts";

/** Playback speed, mm/s: it shows the order of moves, not their real time. */
const SHOWN = { rapid: 150, feed: 30 };
/** Least and greatest duration of a stretch, s. */
const SHORTEST = 1.2;
const LONGEST = 9;

/** Playback time of a stretch of a run. */
export interface PieceTime {
  /** s */
  readonly lasts: number;
  /** The position in the run after some seconds of playback. */
  readonly at: (seconds: number) => PlayPosition;
}

/** Playback time of a stretch of a run; long ones play faster. */
export function pieceTime(
  steps: readonly Pick<Step, "from" | "move">[],
  { from, to }: NonNullable<StepPiece["piece"]>,
): PieceTime {
  let whole = 0;
  const ends = steps
    .slice(from, to)
    .map(
      (step) =>
        (whole += travelOf(pathOf(step.from, step.move)) / (step.move.kind === "rapid" ? SHOWN.rapid : SHOWN.feed)),
    );
  const lasts = Math.min(LONGEST, Math.max(SHORTEST, whole));
  return {
    lasts,
    at(seconds) {
      const sought = (Math.max(0, seconds) / lasts) * whole;
      const index = ends.findIndex((end) => end > sought);
      if (index < 0) return { step: to, fraction: 0 };
      const begun = ends[index - 1] ?? 0,
        length = (ends[index] ?? begun) - begun;
      return { step: from + index, fraction: length > 0 ? (sought - begun) / length : 0 };
    },
  };
}
