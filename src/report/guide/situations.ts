import { neutralValueOf, hasNoEffect, type SomeValues } from "../../cycles/effect.ts";
import type { Cycle, Given } from "../../cycles/define.ts";
import type { Param, Topic } from "../../cycles/params.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { rounded, toDiameter } from "../../kernel/units.ts";
import { neededFor, threeValues, type Candidates } from "./three-values.ts";

/** A situation in which a parameter is demonstrated: other values changed, and the values to show. */
export interface Situation {
  /** Other values changed to make the effect visible, by Q. */
  readonly needed: Readonly<Record<string, number>>;
  /** Null: the present value is the usual one. */
  readonly usual: number | null;
  readonly values: readonly Candidates[];
}

type CycleValues = Readonly<Record<string, number | "auto">>;

/** Positions of a limit, as shares of the contour from the unmachined side. */
const LIMITS_AT = [0.2, 0.45, 0.75] as const;
/** Distance of an ineffective limit behind the contour, mm. */
const OUT_OF_THE_WAY = 2;
/** Angles tried for a value that only some choices use, degrees. */
const ANGLES = [5, 12, 1.5] as const;
/** Shares of the infeed or overlap with which a value may have an effect that it lacks at the usual one. */
const OTHERWISE: Partial<Record<Topic, { readonly of: Topic; readonly times: readonly number[] }>> = {
  direction: { of: "infeed", times: [1.6, 2.5] },
  comb: { of: "overlap", times: [0.75, 0.6, 0.5] },
  cuttingLines: { of: "infeed", times: [0.5, 0.3] },
};
/** Rounds a proposed position to 0.1 mm. */
const tenth = (value: number) => rounded(Number(value.toFixed(1)));

const withTopic = ({ params }: Pick<Cycle, "params">, topic: Topic) =>
  Object.entries<Param>(params).find(([, param]) => param.shown === topic)?.[0];

/** Limits across the contour of a cycle, from the side of the tool at the call; null without a contour. */
function limitsOver(cycle: Cycle, values: CycleValues, given: Given) {
  const [switched, across, along] = [
    withTopic(cycle, "limits"),
    withTopic(cycle, "limitDiameter"),
    withTopic(cycle, "limitZ"),
  ];
  const { contour } = cycle.outline({ ...values, ...(switched && { [switched]: 0 }) } as never, given);
  if (!switched || !across || !along || !given.start || contour.length === 0) return null;
  const box = boxOf(contour.flatMap(({ from, to }) => [from, to]));
  const of = (low: number, high: number, isBeyond: boolean, write: (place: number) => number) => ({
    at: (share: number) => tenth(write(isBeyond ? low + share * (high - low) : high - share * (high - low))),
    away: tenth(write(isBeyond ? low - OUT_OF_THE_WAY : high + OUT_OF_THE_WAY)),
    span: high - low,
  });
  // A start between the two ends of the contour counts as on the side of most of the contour.
  const x = of(box.low, box.high, given.start.r >= (box.low + box.high) / 2, (r) => toDiameter(r as never));
  const z = of(box.left, box.right, given.start.z >= (box.left + box.right) / 2, (place) => place);
  return { switched, across: { q: across, ...x }, along: { q: along, ...z } };
}

/** Situations for the limits of a cycle: one through its contour, the other one ineffective. */
function limitSituations(cycle: Cycle, q: string, values: CycleValues, given: Given): readonly Situation[] {
  const limits = limitsOver(cycle, values, given);
  if (!limits) return [];
  const { switched, across, along } = limits;
  if (q === switched) {
    const [through, other] = along.span > across.span ? [along, across] : [across, along];
    const needed = { [through.q]: through.at(LIMITS_AT[1]), [other.q]: other.away };
    return [{ needed, usual: null, values: threeValues(cycle, q, { ...values, ...needed }) }];
  }
  const [shown, other] = q === across.q ? [across, along] : [along, across];
  if (q !== shown.q) return [];
  const inOrder = LIMITS_AT.map((share) => shown.at(share));
  const usual = inOrder[1] ?? 0;
  return [
    {
      needed: { [switched]: 1, [other.q]: other.away },
      usual,
      values: inOrder.map((value) => ({ tried: [value], isUsual: value === usual })),
    },
  ];
}

/** Values for parameters that only some choices use and that are empty here. */
function dependents(cycle: Cycle, q: string, values: CycleValues): readonly Readonly<Record<string, number>>[] {
  const idle = Object.entries<Param>(cycle.params).filter(
    ([other, param]) => param.condition?.q === q && param.kind === "angle" && values[other] === neutralValueOf(param),
  );
  return idle.length === 0 ? [] : ANGLES.map((angle) => Object.fromEntries(idle.map(([other]) => [other, angle])));
}

/** Other values that give a parameter an effect, one set per choice. */
function waysToCount(cycle: Cycle, q: string, values: CycleValues): readonly Readonly<Record<string, number>>[] {
  const first = neededFor(cycle, q, values);
  const counts = cycle.params[q]?.condition;
  if (!counts || !(counts.q in first)) return [first];
  return counts.among
    .filter((value) => value !== 0 || counts.among.length === 1)
    .map((value) => ({ ...first, [counts.q]: value }));
}

/**
 * The situations in which to demonstrate a parameter, best first: unchanged, then with an effect, then with a larger
 * effect. `values`: all values of its cycle; `given`: the cycle's context.
 */
export function situationsOf(cycle: Cycle, q: string, values: CycleValues, given: Given): readonly Situation[] {
  const param = cycle.params[q];
  if (!param) return [];
  const shownWith = (needed: Readonly<Record<string, number>>): Situation => ({
    needed,
    usual: null,
    values: threeValues(cycle, q, { ...values, ...needed } as SomeValues),
  });
  const counting = waysToCount(cycle, q, values);
  const limits = limitSituations(cycle, q, values, given);
  const isIdle = hasNoEffect({ ...param, reserved: false }, values);
  const plain = [...dependents(cycle, q, values), ...counting].map(shownWith);
  const otherwise = OTHERWISE[param.shown];
  const other = otherwise && withTopic(cycle, otherwise.of);
  const [first = {}] = counting;
  const more =
    !otherwise || !other
      ? []
      : otherwise.times.map((times) => {
          const value = values[other];
          return shownWith({
            ...first,
            ...(typeof value === "number" && { [other]: rounded(Number((value * times).toFixed(2))) }),
          });
        });
  return limits.length > 0 && (isIdle || param.choices) ? [...limits, ...plain] : [...plain, ...limits, ...more];
}
