import type { PlayPosition } from "../sim/simulation.ts";
import { positionAt, type PlayedTrack } from "./playback.ts";

/**
 * A moment of a run at which what goes along with the tool may change its direction: where it comes to, and where it
 * goes on from.
 */
export interface WayBend {
  /** Machine seconds from the start of the run. */
  readonly seconds: number;
  readonly to: PlayPosition;
  readonly from: PlayPosition;
}

/**
 * The moments between two others, machine seconds, at which the tip may turn: the ends of moves and, within a round
 * one, every `fine` seconds. Of those that lie closer together than that the first one stands for all.
 */
export function bendsBetween(
  track: PlayedTrack,
  [begin, end]: readonly [number, number],
  fine: number,
  isRound: (step: number) => boolean,
): readonly WayBend[] {
  const bends: WayBend[] = [];
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
