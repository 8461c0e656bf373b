/**
 * The one clock that animation reads. Normally the browser's; with `?clock=manual` in the address time stands still
 * until a test calls `window.__turnwiseClock.advance(milliseconds)`, so that every picture can be held and repeated.
 */
export interface Clock {
  /** Milliseconds since the page was opened. */
  now(): number;
  /** Calls once at the next picture; returns what cancels it. */
  frame(callback: (now: number) => void): () => void;
}

/** What a test holds in its hand. */
export interface ManualClock {
  now(): number;
  /** Moves time on, picture by picture. */
  advance(milliseconds: number): void;
}

declare global {
  interface Window {
    __turnwiseClock?: ManualClock;
  }
}

/** Time between two pictures of the manual clock, ms. */
const PICTURE = 16;

const browserClock: Clock = {
  now: () => performance.now(),
  frame(callback) {
    const handle = requestAnimationFrame(callback);
    return () => cancelAnimationFrame(handle);
  },
};

/** A clock that only moves when told to. */
export function manualClock(): Clock & ManualClock {
  let time = 0;
  let waiting: ((now: number) => void)[] = [];
  const picture = () => {
    const due = waiting;
    waiting = [];
    for (const callback of due) callback(time);
  };
  return {
    now: () => time,
    frame(callback) {
      const own = (now: number) => callback(now);
      waiting.push(own);
      return () => {
        waiting = waiting.filter((each) => each !== own);
      };
    },
    advance(milliseconds) {
      const end = time + Math.max(0, milliseconds);
      while (time < end) {
        time = Math.min(end, time + PICTURE);
        picture();
      }
    },
  };
}

function chosenClock(): Clock {
  if (typeof location === "undefined" || new URLSearchParams(location.search).get("clock") !== "manual") return browserClock;
  const manual = manualClock();
  window.__turnwiseClock = { now: manual.now, advance: manual.advance };
  return manual;
}

/** The clock of this page. */
export const clock: Clock = chosenClock();
