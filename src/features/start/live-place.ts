import type { LiveRun, Waypoint } from "./pictures.ts";

/** A moment of a playing run. */
export interface LivePlace {
  readonly z: number;
  readonly r: number;
  /** The tool moves towards the chuck: the material beyond it is still there. */
  readonly inwards: boolean;
  /** Indexes of the stock before and after the current move. */
  readonly before: number;
  readonly after: number;
  readonly pass: number;
}

/** Pause on the finished part before the run repeats, ms. */
export const END_PAUSE = 2500;

/** Duration of a run with its pause, ms. */
export const durationOf = ({ way }: LiveRun): number => (way.at(-1)?.[0] ?? 0) + END_PAUSE;

/** The state of a run at a time, ms. */
export function livePlace({ way }: LiveRun, time: number): LivePlace {
  const next = way.findIndex(([at]) => at >= time);
  const last = way.at(-1) as Waypoint;
  const to = next < 0 ? last : (way[next] as Waypoint);
  const from = next < 0 ? last : (way[Math.max(0, next - 1)] as Waypoint);
  const part = to[0] > from[0] ? (time - from[0]) / (to[0] - from[0]) : 1;
  return {
    z: from[1] + (to[1] - from[1]) * part,
    r: from[2] + (to[2] - from[2]) * part,
    inwards: to[1] <= from[1],
    before: from[3],
    after: to[3],
    pass: to[4],
  };
}
