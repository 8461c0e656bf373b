/** Frames later than this, ms, lower the resolution while something moves, by this many at a time, to about `aim` ms. */
const LATE = { ms: 40, frames: 3, aim: 30, by: 0.5, least: 0.4 } as const;
/** After this many early frames, ms, the resolution rises again by a step. */
const SOON = { ms: 24, frames: 90, by: 1.4 } as const;
/** Frames after a change that are not counted: those under way still have the previous resolution. */
const UNDER_WAY = 2;
/** A lowest resolution that does not reduce the delay to this share of the full one's is undone: something else is slow. */
const WORTH = { share: 0.85, frames: 8 } as const;

/** The resolution of frames while something moves. */
export interface Sharpness {
  /** Records the time of a frame, ms; returns the share of pixels along each side, 0 … 1, for the next one. */
  readonly noteFrame: (ms: number) => number;
}

/** Adapts from frame to frame. */
export function createSharpness(): Sharpness {
  let [share, soon, sum, count, underWay] = [1, 0, 0, 0, 0];
  /** The average delay at full resolution, ms; below that of the lowest, only the full one is used. */
  let full = 0;
  let isWorth = true;
  const next = (to: number) => {
    [share, sum, count, underWay] = [to, 0, 0, UNDER_WAY];
    return share;
  };
  return {
    noteFrame(ms) {
      if (underWay > 0) {
        underWay -= 1;
        return share;
      }
      soon = ms < SOON.ms ? soon + 1 : 0;
      if (soon >= SOON.frames) {
        [soon, isWorth] = [0, true];
        return next(Math.min(1, share * SOON.by));
      }
      // One very late frame waited for other work.
      [sum, count] = ms > LATE.ms ? [sum + (full > 0 ? Math.min(ms, full) : ms), count + 1] : [0, 0];
      const isLeast = share <= LATE.least;
      if (!isWorth || count < (isLeast ? WORTH.frames : LATE.frames)) return share;
      const average = sum / count;
      if (isLeast) {
        isWorth = average <= WORTH.share * full;
        return next(isWorth ? share : 1);
      }
      if (share === 1) full = average;
      return next(Math.max(LATE.least, share * Math.max(LATE.by, Math.sqrt(LATE.aim / average))));
    },
  };
}
