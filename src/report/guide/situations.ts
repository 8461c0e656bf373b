import { neutralOf, saysNothing, type SomeValues } from "../../cycles/effect.ts";
import type { Cycle, Given } from "../../cycles/define.ts";
import type { Param, Topic } from "../../cycles/params.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { rounded, toDiameter } from "../../kernel/units.ts";
import { neededFor, threeValues, type Candidates } from "./three-values.ts";

/** A parameter with the other values that it is shown with. */
export interface ShownWith {
  /** Other values that are changed so that something is seen, by Q. */
  readonly needed: Readonly<Record<string, number>>;
  /** Null: the value that stands there already is the usual one. */
  readonly usual: number | null;
  readonly values: readonly Candidates[];
}

type Known = Readonly<Record<string, number | "auto">>;

/** Where a limit is put, as shares of the contour seen from the side that is not machined. */
const LIMITS_AT = [0.2, 0.45, 0.75] as const;
/** A limit that is to be in nobody's way lies this far behind the contour, mm. */
const OUT_OF_THE_WAY = 2;
/** Angles that a value which is asked for elsewhere is given, degrees. */
const ANGLES = [5, 12, 1.5] as const;
/** Parts of the infeed, or of the overlap, with which a value may act where it does not at the usual one. */
const OTHERWISE: Partial<Record<Topic, { readonly of: Topic; readonly times: readonly number[] }>> = {
  direction: { of: "infeed", times: [1.6, 2.5] },
  comb: { of: "overlap", times: [0.75, 0.6, 0.5] },
  cuttingLines: { of: "infeed", times: [0.5, 0.3] },
};
/** How fine a proposed place is, mm. */
const tenth = (value: number) => rounded(Number(value.toFixed(1)));

const withTopic = ({ params }: Pick<Cycle, "params">, topic: Topic) =>
  Object.entries<Param>(params).find(([, param]) => param.shown === topic)?.[0];

/** Limits across the contour of a cycle, from the side on which the tool stands at the call; null where it has none. */
function limitsOver(cycle: Cycle, values: Known, given: Given) {
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
  // A place between the two ends of the contour counts as the side that most of the contour lies on.
  const x = of(box.low, box.high, given.start.r >= (box.low + box.high) / 2, (r) => toDiameter(r as never));
  const z = of(box.left, box.right, given.start.z >= (box.left + box.right) / 2, (place) => place);
  return { switched, across: { q: across, ...x }, along: { q: along, ...z } };
}

/** How the limits of a cycle are shown: one through its contour, the other one out of the way. */
function limitSituations(cycle: Cycle, q: string, values: Known, given: Given): readonly ShownWith[] {
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

/** What is asked for only where a choice wants it, and is empty here, is given something to say. */
function dependents(cycle: Cycle, q: string, values: Known): readonly Readonly<Record<string, number>>[] {
  const idle = Object.entries<Param>(cycle.params).filter(
    ([other, param]) => param.counts?.q === q && param.kind === "angle" && values[other] === neutralOf(param),
  );
  return idle.length === 0 ? [] : ANGLES.map((angle) => Object.fromEntries(idle.map(([other]) => [other, angle])));
}

/** The other values that make a parameter count, each way that its choice allows. */
function waysToCount(cycle: Cycle, q: string, values: Known): readonly Readonly<Record<string, number>>[] {
  const first = neededFor(cycle, q, values);
  const counts = cycle.params[q]?.counts;
  if (!counts || !(counts.q in first)) return [first];
  return counts.among
    .filter((value) => value !== 0 || counts.among.length === 1)
    .map((value) => ({ ...first, [counts.q]: value }));
}

/**
 * With which other values a parameter is shown, the best first: as they are, then so that it counts, then where it acts
 * more than there. `values` are those of its cycle, all of them, `given` what it is given beside them.
 */
export function situationsOf(cycle: Cycle, q: string, values: Known, given: Given): readonly ShownWith[] {
  const param = cycle.params[q];
  if (!param) return [];
  const shownWith = (needed: Readonly<Record<string, number>>): ShownWith => ({
    needed,
    usual: null,
    values: threeValues(cycle, q, { ...values, ...needed } as SomeValues),
  });
  const counting = waysToCount(cycle, q, values);
  const limits = limitSituations(cycle, q, values, given);
  const isIdle = saysNothing({ ...param, reserved: false }, values);
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
