import { isSameTime, type PlanComparison, type PlanRow } from "../../../course/plans/plan-comparison.ts";
import { settableValues, type SettableValue } from "../../../planning/hand-values.ts";
import type { PlanComparisonTexts } from "../../../i18n/en/plan-comparison.ts";
import { timeWords, type StepWords } from "../../../app/fields/plan/plan-words.ts";

/** What the dialog writes with. */
export interface ComparisonWords extends StepWords {
  readonly c: PlanComparisonTexts;
}

const sumOf = (all: readonly { readonly seconds: number }[]): number =>
  all.reduce((sum, { seconds }) => sum + seconds, 0);

/** The operations of a row on both sides. */
export function sidesOf({ own, planned }: PlanComparison, row: PlanRow) {
  const mine = row.own.flatMap((i) => own.operations[i] ?? []);
  const theirs = row.other.flatMap((i) => planned.steps[i] ?? []);
  return { mine, theirs, seconds: { mine: sumOf(mine), theirs: sumOf(theirs) } };
}

/** What differs in a row, in a few words each. */
export function differenceWords(words: ComparisonWords, comparison: PlanComparison, row: PlanRow): readonly string[] {
  const { differs, onlyYours, onlyPlanner } = words.c;
  const { mine, theirs, seconds } = sidesOf(comparison, row);
  if (theirs.length === 0) return [onlyYours];
  if (mine.length === 0) return [onlyPlanner];
  const isSameWay = row.isSameTool && row.isSameCycle && mine.length === theirs.length;
  const difference = timeWords(words, Math.abs(row.longer));
  return [
    ...(isSameWay ? [differs.same] : []),
    ...(row.isSameTool ? [] : [differs.tool]),
    ...(row.isSameCycle ? [] : [differs.cycle]),
    ...(mine.length === theirs.length ? [] : [differs.count(mine.length, theirs.length)]),
    ...(row.moved ? [differs[row.moved]] : []),
    isSameTime(seconds.mine, seconds.theirs)
      ? differs.sameTime
      : (row.longer < 0 ? differs.faster : differs.slower)(difference),
  ];
}

/** A value of the planner beside the own one. */
export interface OtherValue {
  readonly own: number;
  readonly planned: SettableValue;
}

/** Values are the same if they agree to this part. */
const SAME_VALUE = 0.005;

/** Values of the same name that differ, where one operation stands beside one of the same cycle. */
export function otherValues(comparison: PlanComparison, row: PlanRow): readonly OtherValue[] {
  const { mine, theirs } = sidesOf(comparison, row);
  const [one] = mine,
    [other] = theirs;
  if (!one || !other || mine.length + theirs.length > 2 || !row.isSameCycle) return [];
  return settableValues(other.tried.action).flatMap((planned) => {
    if (!planned.reason) return [];
    const own = one.values[planned.q];
    const isSame = own === undefined || Math.abs(own - planned.value) <= SAME_VALUE * Math.abs(planned.value);
    return isSame ? [] : [{ own, planned }];
  });
}
