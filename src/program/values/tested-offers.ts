import type { Cycle, Given } from "../../cycles/define.ts";
import type { Param, Params, Values } from "../../cycles/params.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import { fixesFinding, offerOf, withOffer } from "../../kernel/plan/offer.ts";
import type { Plan, PlanContext } from "../../kernel/plan/plan.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import { axial, diameter, toRadius } from "../../kernel/units.ts";
import { checkNumber } from "./field.ts";
import { LEAST_INFEED, MOST_INFEED, MOST_PASSES_OFFERED, SETTERS_INFEEDS, roundValues } from "./round-values.ts";

/**
 * Issues of a cycle for some values, and the number of planned moves. `passes`: of its roughing; null where no path was
 * planned.
 */
export interface Judgement {
  readonly issues: readonly Issue[];
  readonly moves: number;
  readonly passes: number | null;
}

/** Judges values, from the start point of the call or from another one. */
export type Judge<P extends Params> = (values: Values<P>, start?: Pt) => Judgement;

/**
 * Evaluates values of a cycle: its outline and, with a setting, its plan; an impossible contour is reported without a
 * path. `besides`: other issues of a plan. Null where a contour of a subprogram is missing.
 */
export function judgeOf<P extends Params>(
  cycle: Cycle<P>,
  setting: PlanContext | null,
  given: Given,
  besides: (plan: Plan) => readonly Issue[] = () => [],
): Judge<P> | null {
  if (cycle.contour === "free" && given.contour === null) return null;
  return (values, start) => {
    const from = start ? { ...given, start } : given;
    const { issues } = cycle.outline(values, from);
    if (!setting || issues.some((each) => each.severity === "error")) return { issues, moves: 0, passes: null };
    const plan = cycle.plan(values, start ? { ...setting, start } : setting, from);
    return { issues: [...issues, ...plan.issues, ...besides(plan)], moves: plan.moves.length, passes: plan.passes };
  };
}

type Kept = Readonly<Record<string, number | "auto">>;
/** Whether a value works; null where testing costs too much. */
type Works = (value: number) => boolean | null;

/** Limit of planned moves in the search for one value. */
const MOST_MOVES = 1500;
/** Growth of the distance between probes and the offered value. */
const STRIDE = 4;
/** Bisections from a found value to the grid. */
const HALVINGS = 20;
/** Parameters that determine the number of passes: a value with too many passes is not offered. */
const DIVIDES: ReadonlySet<Param["shown"]> = new Set<Param["shown"]>(["infeed", "depthLimit", "overlap"]);

/** Rounds to the resolution of a parameter, within its range. */
function gridOf({ decimals, range: [min, max] }: Param): (value: number) => number {
  const scale = 10 ** decimals;
  return (value) => Math.round(Math.min(max, Math.max(min, value)) * scale) / scale + 0;
}

/** Smallest usual infeed that works; cheap to test, as it needs few passes. */
function smallestInfeed(param: Param, works: Works): number | null {
  const kept = gridOf(param);
  const sizes = SETTERS_INFEEDS.filter((size) => kept(size) === size);
  const bad = sizes.findIndex((size) => works(size) !== true);
  return (bad < 0 ? sizes.at(-1) : sizes[bad - 1]) ?? null;
}

/** Nearest value to `offer` that works and is round; null when the search finds none. */
function search(param: Param, offer: number, from: number | null, works: Works): number | null {
  const kept = gridOf(param);
  if (param.choices) {
    const others = [...param.choices]
      .filter((each) => each !== from)
      .sort((a, b) => Math.abs(a - offer) - Math.abs(b - offer));
    return others.find((each) => works(each) === true) ?? null;
  }
  const first = kept(offer);
  // In place of nothing or a tiny infeed, a setter types the usual one; tiny ones also cost most to test.
  if (DIVIDES.has(param.shown) && from !== null && from < first && works(param.example)) return param.example;
  if (DIVIDES.has(param.shown) && from !== null && from < first)
    return first >= LEAST_INFEED && works(first) ? typed(first, 1) : smallestInfeed(param, works);
  const way = Math.sign(first - (from ?? first)) || -1;
  if (DIVIDES.has(param.shown) && first > MOST_INFEED)
    return SETTERS_INFEEDS.find((size) => works(size) === true) ?? null;
  const verdict = works(first);
  if (verdict !== false) return verdict ? typed(first, way) : null;
  for (const direction of [way, -way]) {
    let bad = first;
    for (let d = 1 / 10 ** param.decimals; ; d *= STRIDE) {
      const probe = kept(first + direction * d);
      if (probe === bad) break;
      const good = works(probe);
      if (good === null) return null;
      if (good) return typed(between(bad, probe, kept, works), direction);
      bad = probe;
    }
  }
  return null;

  /** The value rounded away from failing ones, where the result works too. */
  function typed(value: number, on: number): number {
    // A value required by a profile must not be exceeded.
    if (param.kind === "count" || param.shown === "threadDepth") return value;
    return roundValues(value, on).find((each) => kept(each) === each && works(each) === true) ?? value;
  }
}

function between(bad: number, good: number, kept: (value: number) => number, works: Works): number {
  let [no, yes] = [bad, good];
  for (let i = 0; i < HALVINGS; i += 1) {
    const middle = kept((no + yes) / 2);
    if (middle === no || middle === yes) break;
    if (works(middle)) yes = middle;
    else no = middle;
  }
  return yes;
}

/** Codes where a wrong sign may be the cause. */
const BY_SIGN: ReadonlySet<Issue["code"]> = new Set<Issue["code"]>(["outOfRange", "diameterNegative"]);

/** The value with the other sign, where that may be intended. */
function otherSign({ code, data }: Issue): number | null {
  return BY_SIGN.has(code) && "value" in data && typeof data.value === "number" && data.value !== 0
    ? -data.value
    : null;
}

/**
 * Tests every value that a finding offers: rounded, it must remove the finding without a new error. Otherwise offers
 * the nearest value that does, or none. A dimension of the drawing is never offered, only its other sign where the
 * typed one is impossible. `kept`: valid values; while others are missing only the range is tested.
 */
export function testedOffers<P extends Params>(
  params: P,
  kept: Kept,
  found: readonly Issue[],
  judge: Judge<P> | null,
  start: Pt | null = null,
): readonly Issue[] {
  const tried = (each: Issue): Issue => {
    const [offer, q] = [offerOf(each), each.at];
    if (offer === null || q === undefined) return each;
    const param = params[q];
    if (!param) return triedStart(each, offer);
    const complete = Object.keys(params).every((name) => name === q || name in kept);
    let moves = 0;
    const works: Works = (value) => {
      if (checkNumber({ ...param, id: q }, value)) return false;
      const divides = DIVIDES.has(param.shown);
      // The usual value is offered even where its passes are not planned.
      const isSafe = !divides || value === param.example;
      if (!judge || !complete) return isSafe;
      if (moves > MOST_MOVES) return null;
      const judged = judge({ ...kept, [q]: value } as unknown as Values<P>);
      moves += judged.moves + 1;
      return (
        fixesFinding(each, found, judged.issues) &&
        (judged.passes === null ? isSafe : !divides || judged.passes <= MOST_PASSES_OFFERED)
      );
    };
    const sign = otherSign(each);
    if (sign !== null && works(sign)) return withOffer(each, sign);
    if (param.drawn) return withOffer(each, null);
    const now = "value" in each.data && typeof each.data.value === "number" ? each.data.value : kept[q];
    return withOffer(each, search(param, offer, typeof now === "number" ? now : null, works));
  };
  /** Tests an offered ⌀ or Z of the start point. */
  const triedStart = (each: Issue, offer: number): Issue => {
    const isX = each.at === "start.x";
    if (!judge || !start || !(isX || each.at === "start.z") || !Object.keys(params).every((name) => name in kept))
      return each;
    const other = isX ? { ...start, r: toRadius(diameter(offer)) } : { ...start, z: axial(offer) };
    return withOffer(each, fixesFinding(each, found, judge(kept as unknown as Values<P>, other).issues) ? offer : null);
  };
  return found.map(tried);
}
