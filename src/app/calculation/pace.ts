import { PLANNING } from "../base/waits.ts";
import type { Request } from "./request.ts";

/** How fast the open work is planned. */
export interface Pace {
  /** Times of its last runs, on the page or in the worker, ms. The quickest counts: others may have been delayed. */
  readonly runs: readonly number[];
  /** Time of its first run in the worker, ms. */
  readonly first: number;
  /**
   * A long text has been planned on the page while idle, or its first run was quick: an unmeasured one could block the
   * page.
   */
  readonly isKnown: boolean;
}

/** The pace of a work that has not been run. */
export const UNKNOWN_PACE: Pace = { runs: [], first: Infinity, isKnown: false };

/** Number of runs that decide whether the page plans, and whether a digit is drawn before its path. */
const LAST = 3,
  LAST_SLOW = 4;

/** Characters of a program and of the files it can call. */
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
 * Whether a text of this length is planned quickly. A long one not yet planned on the page needs all of the last runs
 * to be quick, and is never quick while it is planned ahead; any other text needs one.
 */
export function isQuick({ runs, isKnown }: Pace, characters: number, isPlannedAhead: boolean): boolean {
  const isFamiliar = characters <= PLANNING.short || isKnown;
  if (!isFamiliar && isPlannedAhead) return false;
  const quick = runs.slice(-LAST).filter((took) => took <= PLANNING.onPage).length;
  return runs.length === 0 ? isFamiliar : quick >= (isFamiliar ? 1 : LAST);
}

/**
 * Whether a digit is drawn before its path is planned: two of the last runs exceeded the limit for a digit. One may
 * have been delayed, and a value that was undone is cached and quick.
 */
export const isSlow = ({ runs }: Pace): boolean => (runs.toSorted((a, b) => b - a)[1] ?? 0) > PLANNING.withDigit;

/** Whether the page may plan a work ahead, after its first run. */
export const mayWarmUp = (characters: number, took: number): boolean =>
  characters <= PLANNING.short
    ? took <= PLANNING.warmUp
    : characters <= PLANNING.longest && took <= PLANNING.longWarmUp;
