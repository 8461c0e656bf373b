/**
 * Pictures that come later than this after they were asked for, ms, are drawn with fewer pixels while something moves:
 * after so many, of which a very late one counts as a few; then how many fewer, and the fewest. After so many that come
 * soon there are more again.
 */
const SLOW = { ms: 40, pictures: 6, few: 3, by: 0.7, least: 0.4 } as const;
const SOON = { ms: 24, pictures: 90 } as const;
/**
 * Fewer pixels that do not bring pictures to so much of their lateness before are given back: something else is slow.
 */
const WORTH = 0.85;

/** How sharp pictures may be while something moves. */
export interface Sharpness {
  /**
   * Takes note of how long a picture took, ms; returns the share of the pixels along each side, 0 … 1, for what comes
   * next.
   */
  readonly took: (ms: number) => number;
}

/** Learns from picture to picture. */
export function createSharpness(): Sharpness {
  let [share, late, soon, sum, count] = [1, 0, 0, 0, 0];
  /** The share before the last step down, and how late pictures were there on average. */
  let before: { readonly share: number; readonly ms: number } | null = null;
  let isWorth = true;
  const next = (to: number) => {
    [share, late, sum, count] = [to, 0, 0, 0];
    return share;
  };
  return {
    took(ms) {
      soon = ms < SOON.ms ? soon + 1 : 0;
      if (soon >= SOON.pictures) {
        [soon, before, isWorth] = [0, null, true];
        return next(Math.min(1, share / SLOW.by));
      }
      [late, sum, count] =
        ms > SLOW.ms ? [late + Math.min(SLOW.few, Math.floor(ms / SLOW.ms)), sum + ms, count + 1] : [0, 0, 0];
      if (late < SLOW.pictures) return share;
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
