import { IDLE } from "./waits.ts";

/** Runs once the browser is idle for at least `least` ms. Returns a function that cancels the call. */
export function scheduleIdle(run: () => void, least = 0): () => void {
  if (typeof requestIdleCallback === "function") {
    let calm = 0;
    const look = (rest: IdleDeadline) => {
      calm = rest.timeRemaining() >= IDLE.calm ? calm + 1 : 0;
      if (rest.timeRemaining() >= least || calm >= IDLE.calmPictures) run();
      else id = requestIdleCallback(look);
    };
    let id = requestIdleCallback(look);
    return () => cancelIdleCallback(id);
  }
  const timer = setTimeout(run, IDLE.unknown);
  return () => clearTimeout(timer);
}

/**
 * Prefetches a part on the first input or when the browser is idle. A failed fetch is repeated when the part is needed.
 */
export function prefetchIdle(fetch: () => Promise<unknown>): () => void {
  const begins = ["pointermove", "pointerdown", "keydown"];
  const now = () => {
    stop();
    void fetch().catch(() => undefined);
  };
  const notYet = scheduleIdle(now);
  const stop = () => {
    notYet();
    for (const sign of begins) removeEventListener(sign, now);
  };
  for (const sign of begins) addEventListener(sign, now, { passive: true });
  return stop;
}
