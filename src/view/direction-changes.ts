import type { PlayPosition } from "../sim/simulation.ts";
import { positionAt, type PlayedTrack } from "./playback.ts";

/**
 * A moment of a run at which the tool may change direction: the position at the end of one stretch, and the position at
 * the start of the next.
 */
export interface DirectionChange {
  /** Machine seconds from the start of the run. */
  readonly seconds: number;
  readonly to: PlayPosition;
  readonly from: PlayPosition;
}

/**
 * Moments between two others, machine seconds, at which the tip may change direction: the ends of moves and, within an
 * arc, every `fine` seconds. Of moments closer together than `fine`, only the first counts.
 */
export function directionChanges(
  track: PlayedTrack,
  [begin, end]: readonly [number, number],
  fine: number,
  isRound: (step: number) => boolean,
): readonly DirectionChange[] {
  const bends: DirectionChange[] = [];
  let last = begin;
  const put = (seconds: number, to: PlayPosition | null) => {
    const from = positionAt(track, seconds);
    bends.push({ seconds, to: to ?? from, from });
    last = seconds;
  };
  for (let { step } = positionAt(track, begin); step < track.ends.length; step += 1) {
    const done = track.ends[step] ?? 0;
    if (isRound(step)) {
      while (last + fine < Math.min(done, end)) put(last + fine, null);
    }
    if (done >= end) break;
    if (done - last >= fine) put(done, { step, fraction: 1 });
  }
  return bends;
}
