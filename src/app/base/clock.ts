/**
 * The only source of time. Normally that of the browser; with `?clock=manual` in the address time stands still until a
 * test calls `window.__turnwiseClock.advance(milliseconds)`, so that every frame can be reproduced. With
 * `?clock=2026-11-21T08:00` it starts at that local time, so that dates are reproducible too.
 */
export interface Clock {
  /** Whether time passes by itself, so that the browser can run animations. */
  readonly flows: boolean;
  /** Milliseconds since the page was opened. */
  now(): number;
  /** Calls once at the next frame; returns a function that cancels the call. */
  frame(callback: (now: number) => void): () => void;
}

/** The control of time for tests. */
export interface ManualClock {
  now(): number;
  /** Advances time frame by frame. */
  advance(milliseconds: number): void;
}

declare global {
  interface Window {
    __turnwiseClock?: ManualClock;
  }
}

/** Frame interval of the manual clock, ms. */
const PICTURE = 16;

const browserClock: Clock = {
  flows: true,
  now: () => performance.now(),
  frame(callback) {
    const handle = requestAnimationFrame(callback);
    return () => cancelAnimationFrame(handle);
  },
};

/** A clock that only `advance` moves. */
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

/** Local time at which manual time starts when the address names none. */
const FIRST_DAY = "2026-01-01T08:00";

/** Start of manual time, ms since 1970; null where the browser's time is used. */
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

/** The clock of this page's frames. */
export const clock: Clock = chosen;

/** The time of day, ms since 1970, for everything that carries a date. */
export const time = (): number => chosen.time();

/**
 * Converts a time of this page or worker (ms since its start) to ms since 1970, which page and worker have in common.
 */
export const dayMoment = (sinceBegin: number): number => performance.timeOrigin + sinceBegin;

/** Real time, ms, also with a manual clock: for pauses only, never for anything shown or stored. */
export const stopwatch = (): number => performance.now();
