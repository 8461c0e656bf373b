import { SAME } from "../tolerance.ts";
import { roundedUpTo } from "../units.ts";

/** Turns of the spindle within which any axis is up to the feed: longer run-ins nobody programs. */
const USUAL_TURNS = 10;
/** The step of run-ins that a setter types, mm. */
export const RUN_IN_STEP = 0.5;

/**
 * The shortest run-in of a usual length from which on the tool begins in free air, where it does not from one of
 * `blocked`; null when none does. mm
 */
export function shortestRunIn(isFree: (runIn: number) => boolean, blocked: number, lead: number): number | null {
  const longest = Math.max(USUAL_TURNS * lead, 2 * blocked);
  if (!isFree(longest)) return null;
  let [low, high] = [blocked, longest];
  while (high - low > SAME) {
    const middle = (low + high) / 2;
    if (isFree(middle)) high = middle;
    else low = middle;
  }
  const typed = roundedUpTo(RUN_IN_STEP, high);
  return isFree(typed) ? typed : null;
}
