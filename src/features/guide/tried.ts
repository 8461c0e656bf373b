import type { Box } from "../../kernel/geometry/segments.ts";
import {
  makesPath,
  shownBox,
  shownChange,
  shownEffect,
  type ShownChange,
  type ShownEffect,
} from "../../report/guide/shown-effect.ts";
import type { Outcome } from "../../app/calculation/outcome.ts";

/** What was run with one value. */
export interface RanValue {
  /** It is the one that the others are compared with. */
  readonly isUsual: boolean;
  readonly outcome: Outcome;
}

/** A value with what comes of it. */
export interface TriedOutcome extends RanValue {
  readonly effect: ShownEffect;
  /** Against the usual value; null for that itself, and where one of the two makes no path. */
  readonly change: ShownChange | null;
}

/**
 * Runs beside each other, in one box of the part; null where the usual one does not go, which is to make the path of a
 * cycle.
 */
export function compared<R extends RanValue>(
  ran: readonly R[],
  goes: (outcome: Outcome) => boolean = makesPath,
): { readonly tried: readonly (R & TriedOutcome)[]; readonly box: Box } | null {
  const usual = ran.find((each) => each.isUsual && goes(each.outcome));
  if (!usual) return null;
  const tried = ran.map((each) => ({
    ...each,
    effect: shownEffect(each.outcome),
    change: each === usual || !goes(each.outcome) ? null : shownChange(each.outcome, usual.outcome),
  }));
  return { tried, box: shownBox(ran.map(({ outcome }) => outcome)) };
}
