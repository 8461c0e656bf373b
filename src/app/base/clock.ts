/**
 * The one place that knows what time it is. Normally the browser's time; with `?clock=manual` in the address it stands
 * still until a test calls `window.__turnwiseClock.advance(milliseconds)`, so that every picture can be held and
 * repeated. With `?clock=2026-11-21T08:00` it stands at that moment of the local day, so that every date does so too.
 */
export interface Clock {
  /** Whether time passes by itself, as it does for what the browser moves. */
  readonly flows: boolean;
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
  flows: true,
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
    flows: false,
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

/** The day and the hour at which held time begins when the address names none, in local time. */
const FIRST_DAY = "2026-01-01T08:00";

/** Where held time begins, in milliseconds since 1970; null where time is the browser's. */
export function heldTime(search: string): number | null {
  const asked = new URLSearchParams(search).get("clock");
  if (asked === null) return null;
  const moment = Date.parse(asked.length === "2026-01-01".length ? `${asked}T00:00` : asked);
  if (Number.isFinite(moment)) return moment;
  return asked === "manual" ? Date.parse(FIRST_DAY) : null;
}

function chosenClock(): Clock & { readonly time: () => number } {
  const held = typeof location === "undefined" ? null : heldTime(location.search);
  if (held === null) return { ...browserClock, time: () => Date.now() };
  const manual = manualClock();
  window.__turnwiseClock = { now: manual.now, advance: manual.advance };
  return { ...manual, time: () => held + manual.now() };
}

const chosen = chosenClock();

/** The clock of this page's pictures. */
export const clock: Clock = chosen;

/** The time of day, in milliseconds since 1970: of whatever carries a date. */
export const time = (): number => chosen.time();

/**
 * The moment, ms since 1970, that lies so many ms behind the beginning of this page or worker: they tell moments to
 * each other by it.
 */
export const dayMoment = (sinceBegin: number): number => performance.timeOrigin + sinceBegin;

/** Milliseconds that really pass, held or not: for pauses, and for nothing that is shown or kept. */
export const stopwatch = (): number => performance.now();
