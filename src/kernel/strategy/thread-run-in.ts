import { SAME } from "../tolerance.ts";
import { roundedUpTo } from "../units.ts";

/** Spindle revolutions within which any axis reaches the feed: longer run-ins are not common. */
const USUAL_TURNS = 10;
/** The step of run-ins that an operator types, mm. */
export const RUN_IN_STEP = 0.5;

/**
 * The shortest run-in of a common length from which the tool starts in free air, if it does not from one of `blocked`;
 * null if none does. mm
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
