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

/** The simulation of one value. */
export interface SimulatedValue {
  /** The others are compared with this one. */
  readonly isUsual: boolean;
  readonly outcome: Outcome;
}

/** A value with its effect. */
export interface ComparedValue extends SimulatedValue {
  readonly effect: ShownEffect;
  /** Change from the default value; null for the default itself, and if one of the two makes no path. */
  readonly change: ShownChange | null;
}

/**
 * The simulated values in common bounds; null if the default one does not meet `goes`, by default that it makes the
 * path of a cycle.
 */
export function comparedValues<R extends SimulatedValue>(
  ran: readonly R[],
  goes: (outcome: Outcome) => boolean = makesPath,
): { readonly tried: readonly (R & ComparedValue)[]; readonly box: Box } | null {
  const usual = ran.find((each) => each.isUsual && goes(each.outcome));
  if (!usual) return null;
  const tried = ran.map((each) => ({
    ...each,
    effect: shownEffect(each.outcome),
    change: each === usual || !goes(each.outcome) ? null : shownChange(each.outcome, usual.outcome),
  }));
  return { tried, box: shownBox(ran.map(({ outcome }) => outcome)) };
}
