import type { Cycle, Given } from "../../cycles/define.ts";
import type { Param, Params, Values } from "../../cycles/params.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import { mends, offerOf, withOffer } from "../../kernel/plan/offer.ts";
import type { Setting } from "../../kernel/plan/plan.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import { axial, diameter, toRadius } from "../../kernel/units.ts";
import { checkNumber } from "./field.ts";
import { LEAST_INFEED, MOST_INFEED, MOST_PASSES_OFFERED, SETTERS_INFEEDS, typable } from "./typable.ts";

/**
 * What a cycle says to values, and how many moves it took to say it. `passes`: of its roughing; null where no path was
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
 * Asks a cycle about values: what its outline says and, with a setting, what its plan says; a contour that can not be
 * is said without a path. Null where a contour of a subprogram is missing.
 */
export function judgeOf<P extends Params>(cycle: Cycle<P>, setting: Setting | null, given: Given): Judge<P> | null {
  if (cycle.contour === "free" && given.contour === null) return null;
  return (values, start) => {
    const from = start ? { ...given, start } : given;
    const { issues } = cycle.outline(values, from);
    if (!setting || issues.some((each) => each.severity === "error")) return { issues, moves: 0, passes: null };
    const plan = cycle.plan(values, start ? { ...setting, start } : setting, from);
    return { issues: [...issues, ...plan.issues], moves: plan.moves.length, passes: plan.passes };
  };
}

type Kept = Readonly<Record<string, number | "auto">>;
/** Whether a value works; null where finding out would cost too much. */
type Works = (value: number) => boolean | null;

/** Moves that may be planned to look for one value; then the search gives up. */
const MOST_MOVES = 5000;
/** How much farther each next probe lies from the offered value. */
const STRIDE = 4;
/** Halvings that bring a value found to the grid. */
const HALVINGS = 20;
/** What divides the work into passes: another value that nobody would wait for is no offer. */
const DIVIDES: ReadonlySet<Param["shown"]> = new Set<Param["shown"]>(["infeed", "depthLimit", "overlap"]);

/** Rounds to the grid of a parameter, within its range. */
function gridOf({ decimals, range: [min, max] }: Param): (value: number) => number {
  const scale = 10 ** decimals;
  return (value) => Math.round(Math.min(max, Math.max(min, value)) * scale) / scale + 0;
}

/** The smallest infeed of those that setters type which works; it needs few passes, so it is cheap to try. */
function smallestInfeed(param: Param, works: Works): number | null {
  const kept = gridOf(param);
  const sizes = SETTERS_INFEEDS.filter((size) => kept(size) === size);
  const bad = sizes.findIndex((size) => works(size) !== true);
  return (bad < 0 ? sizes.at(-1) : sizes[bad - 1]) ?? null;
}

/** The nearest value to `offer` that works and that a setter would type; null when the search finds none. */
function search(param: Param, offer: number, from: number | null, works: Works): number | null {
  const kept = gridOf(param);
  if (param.choices) {
    const others = [...param.choices]
      .filter((each) => each !== from)
      .sort((a, b) => Math.abs(a - offer) - Math.abs(b - offer));
    return others.find((each) => works(each) === true) ?? null;
  }
  const first = kept(offer);
  // A tiny one costs more moves to try than all that setters type.
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

  /** A value rounded on, away from what does not work, where that works as well. */
  function typed(value: number, on: number): number {
    // What a profile asks for is no limit that may be passed.
    if (param.kind === "count" || param.shown === "threadDepth") return value;
    return typable(value, on).find((each) => kept(each) === each && works(each) === true) ?? value;
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

/** Codes of a value whose sign may be what is wrong with it. */
const BY_SIGN: ReadonlySet<Issue["code"]> = new Set<Issue["code"]>(["outOfRange", "diameterNegative"]);

/** The value with the other sign, where that is what may have been meant. */
function otherSign({ code, data }: Issue): number | null {
  return BY_SIGN.has(code) && "value" in data && typeof data.value === "number" && data.value !== 0
    ? -data.value
    : null;
}

/**
 * Every value that a finding offers for a parameter is tried before it is offered: rounded to what somebody would type,
 * it must remove the finding and bring no new error. Where it does not, the nearest value that does is looked for, and
 * where there is none the finding offers nothing. A dimension of the drawing is never offered, only its other sign
 * where that of the value is impossible. `kept` holds the values that can be used; while others are missing only the
 * range can be tried.
 */
export function triedOffers<P extends Params>(
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
      if (!judge || !complete) return !divides;
      if (moves > MOST_MOVES) return null;
      const judged = judge({ ...kept, [q]: value } as unknown as Values<P>);
      moves += judged.moves + 1;
      return (
        mends(each, found, judged.issues) &&
        (!divides || (judged.passes !== null && judged.passes <= MOST_PASSES_OFFERED))
      );
    };
    const sign = otherSign(each);
    if (sign !== null && works(sign)) return withOffer(each, sign);
    if (param.drawn) return withOffer(each, null);
    const now = "value" in each.data && typeof each.data.value === "number" ? each.data.value : kept[q];
    return withOffer(each, search(param, offer, typeof now === "number" ? now : null, works));
  };
  /** A diameter or a Z of the start point. */
  const triedStart = (each: Issue, offer: number): Issue => {
    const isX = each.at === "start.x";
    if (!judge || !start || !(isX || each.at === "start.z") || !Object.keys(params).every((name) => name in kept))
      return each;
    const other = isX ? { ...start, r: toRadius(diameter(offer)) } : { ...start, z: axial(offer) };
    return withOffer(each, mends(each, found, judge(kept as unknown as Values<P>, other).issues) ? offer : null);
  };
  return found.map(tried);
}
