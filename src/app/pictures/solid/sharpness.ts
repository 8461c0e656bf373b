/**
 * Frames later than this after their request, ms, lower the resolution while something moves: number of late frames,
 * weight of a very late one, factor of a step, lowest share. After enough early frames it rises again.
 */
const SLOW = { ms: 40, pictures: 6, few: 3, by: 0.7, least: 0.4 } as const;
const SOON = { ms: 24, pictures: 90 } as const;
/** Frames after a change that are not counted: those under way still have the previous resolution. */
const UNDER_WAY = 3;
/** A lower resolution that does not reduce the delay to this share is undone: something else is slow. */
const WORTH = 0.85;

/** The resolution of frames while something moves. */
export interface Sharpness {
  /** Records the time of a frame, ms; returns the share of pixels along each side, 0 … 1, for the next one. */
  readonly noteFrame: (ms: number) => number;
}

/** Adapts from frame to frame. */
export function createSharpness(): Sharpness {
  let [share, late, soon, sum, count, underWay] = [1, 0, 0, 0, 0, 0];
  /** The share before the last step down, and the average delay there. */
  let before: { readonly share: number; readonly ms: number } | null = null;
  let isWorth = true;
  const next = (to: number) => {
    [share, late, sum, count, underWay] = [to, 0, 0, 0, UNDER_WAY];
    return share;
  };
  return {
    noteFrame(ms) {
      if (underWay > 0) {
        underWay -= 1;
        return share;
      }
      soon = ms < SOON.ms ? soon + 1 : 0;
      if (soon >= SOON.pictures) {
        [soon, before, isWorth] = [0, null, true];
        return next(Math.min(1, share / SLOW.by));
      }
      [late, sum, count] =
        ms > SLOW.ms ? [late + Math.min(SLOW.few, Math.floor(ms / SLOW.ms)), sum + ms, count + 1] : [0, 0, 0];
      // A step is soon made, but judged by as many frames as it takes to tell.
      if (late < SLOW.pictures || (before && count < SLOW.pictures)) return share;
      const average = sum / count;
      if (before && average > WORTH * before.ms) {
        isWorth = false;
        return next(before.share);
      }
      if (!isWorth || share <= SLOW.least) return next(share);
      before = { share, ms: average };
      return next(Math.max(SLOW.least, share * SLOW.by));
    },
  };
}
