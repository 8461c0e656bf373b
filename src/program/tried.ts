import type { Cycle, Given } from "../cycles/define.ts";
import type { Param, Params, Values } from "../cycles/params.ts";
import type { Issue } from "../kernel/issue.ts";
import { mends, offerOf, withOffer } from "../kernel/offer.ts";
import type { Setting } from "../kernel/plan.ts";
import { checkNumber } from "./field.ts";

/** What a cycle says to values, and how many moves it took to say it. */
export interface Judgement {
  readonly issues: readonly Issue[];
  readonly moves: number;
}

/**
 * Asks a cycle about values: what its outline says and, with a setting, what its plan says; a contour that can not be is said
 * without a path. Null where a contour of a subprogram is missing.
 */
export function judgeOf<P extends Params>(
  cycle: Cycle<P>,
  setting: Setting | null,
  given: Given,
): ((values: Values<P>) => Judgement) | null {
  if (cycle.contour === "free" && given.contour === null) return null;
  return (values) => {
    const { issues } = cycle.outline(values, given);
    if (!setting || issues.some((each) => each.severity === "error")) return { issues, moves: 0 };
    const plan = cycle.plan(values, setting, given);
    return { issues: [...issues, ...plan.issues], moves: plan.moves.length };
  };
}

type Kept = Readonly<Record<string, number | "auto">>;

/** Moves that may be planned to look for one value; then the search gives up. */
const MOST_MOVES = 5000;
/** How much farther each next probe lies from the offered value. */
const STRIDE = 4;
/** Halvings that bring a value found to the grid. */
const HALVINGS = 20;

/** The nearest value to `offer` that works, on the grid of the parameter; null when the search finds none. */
function search(param: Param, offer: number, from: number | null, works: (value: number) => boolean | null): number | null {
  const scale = 10 ** param.decimals;
  const [min, max] = param.range;
  const kept = (value: number) => Math.round(Math.min(max, Math.max(min, value)) * scale) / scale + 0;
  if (param.choices) {
    const others = [...param.choices].filter((each) => each !== from).sort((a, b) => Math.abs(a - offer) - Math.abs(b - offer));
    return others.find((each) => works(each) === true) ?? null;
  }
  const first = kept(offer);
  const verdict = works(first);
  if (verdict !== false) return verdict ? first : null;
  const way = Math.sign(first - (from ?? first)) || -1;
  for (const direction of [way, -way]) {
    let bad = first;
    for (let d = 1 / scale;; d *= STRIDE) {
      const probe = kept(first + direction * d);
      if (probe === bad) break;
      const good = works(probe);
      if (good === null) return null;
      if (good) return between(bad, probe, kept, works);
      bad = probe;
    }
  }
  return null;
}

function between(bad: number, good: number, kept: (value: number) => number, works: (value: number) => boolean | null): number {
  let [no, yes] = [bad, good];
  for (let i = 0; i < HALVINGS; i += 1) {
    const middle = kept((no + yes) / 2);
    if (middle === no || middle === yes) break;
    if (works(middle)) yes = middle;
    else no = middle;
  }
  return yes;
}

/**
 * Every value that a finding offers for a parameter is tried before it is offered: rounded to what the control keeps, it must
 * remove the finding and bring no new error. Where it does not, the nearest value that does is looked for, and where there is none
 * the finding offers nothing. `kept` holds the values that can be used; while others are missing only the range can be tried.
 */
export function triedOffers<P extends Params>(
  params: P,
  kept: Kept,
  found: readonly Issue[],
  judge: ((values: Values<P>) => Judgement) | null,
): readonly Issue[] {
  const tried = (each: Issue): Issue => {
    const [offer, q] = [offerOf(each), each.at];
    const param = q === undefined ? undefined : params[q];
    if (offer === null || q === undefined || !param) return each;
    const complete = Object.keys(params).every((name) => name === q || name in kept);
    let moves = 0;
    const works = (value: number): boolean | null => {
      if (checkNumber({ ...param, id: q }, value)) return false;
      if (!judge || !complete) return true;
      if (moves > MOST_MOVES) return null;
      const judged = judge({ ...kept, [q]: value } as unknown as Values<P>);
      moves += judged.moves + 1;
      return mends(each, found, judged.issues);
    };
    const now = "value" in each.data && typeof each.data.value === "number" ? each.data.value : kept[q];
    return withOffer(each, search(param, offer, typeof now === "number" ? now : null, works));
  };
  return found.map(tried);
}
