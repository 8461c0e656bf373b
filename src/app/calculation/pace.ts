import { PLANNING } from "../base/waits.ts";
import type { Request } from "./request.ts";

/** How fast the open work is planned. */
export interface Pace {
  /** What its last runs took, on the page or in the worker, ms. The quickest counts: others had to wait for something. */
  readonly runs: readonly number[];
  /** What its first run took in the worker, ms. */
  readonly first: number;
  /** A long text has been planned on the page at rest, or its first run was quick: one of which nothing is known could halt it. */
  readonly isKnown: boolean;
}

/** The pace of a work that was never run. */
export const UNKNOWN_PACE: Pace = { runs: [], first: Infinity, isKnown: false };

/** Runs that decide whether the page plans, and whether a digit is drawn before its path. */
const LAST = 3,
  LAST_SLOW = 4;

/** Characters of a program and of all that it can call. */
export const lengthOf = ({ text, files = [] }: Pick<Request, "text" | "files">): number =>
  files.reduce((sum, file) => sum + file.text.length, text.length);

/** The pace after one more run, ms. */
export const withRun = (pace: Pace, took: number): Pace => ({
  ...pace,
  runs: [...pace.runs.slice(1 - LAST_SLOW), took],
});

/** The pace after a run in the worker, which may be the first of the work, ms. */
export function withRunInWorker(pace: Pace, took: number): Pace {
  const isFirst = pace.runs.length === 0;
  const known = isFirst ? { isKnown: pace.isKnown || took <= PLANNING.onPage, first: took } : {};
  return withRun({ ...pace, ...known }, took);
}

/**
 * Whether a text of a length is quickly planned. Of a long one that the page has not planned yet all of the last runs
 * have to be quick, and none is while it is planned ahead; of any other text one of them.
 */
export function isQuick({ runs, isKnown }: Pace, characters: number, isPlannedAhead: boolean): boolean {
  const isFamiliar = characters <= PLANNING.short || isKnown;
  if (!isFamiliar && isPlannedAhead) return false;
  const quick = runs.slice(-LAST).filter((took) => took <= PLANNING.onPage).length;
  return runs.length === 0 ? isFamiliar : quick >= (isFamiliar ? 1 : LAST);
}

/**
 * True where a digit is drawn before its path is planned: two of the last runs took longer than anybody waits for a
 * digit. One may have had to wait for something, and what was taken back is known and quick.
 */
export const isSlow = ({ runs }: Pace): boolean => (runs.toSorted((a, b) => b - a)[1] ?? 0) > PLANNING.withDigit;

/** Whether a work that was run once may be planned on the page ahead of its first key. */
export const mayWarmUp = (characters: number, took: number): boolean =>
  characters <= PLANNING.short
    ? took <= PLANNING.warmUp
    : characters <= PLANNING.longest && took <= PLANNING.longWarmUp;
