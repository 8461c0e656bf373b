import type { Cycle, Given } from "../../cycles/define.ts";
import { rounded } from "../../kernel/units.ts";
import { LEAST_SEEN, makesPath, shownChange, type RanProgram } from "./shown-effect.ts";
import { situationsOf, type Situation } from "./situations.ts";
import { finestOf, type Candidates } from "./three-values.ts";
import { pathDistance } from "./path-distance.ts";

/** One demonstrated value of a parameter, with its run. */
export interface ValueRun<R> {
  readonly value: number | "auto";
  /** True for the value that the others are compared with. */
  readonly isUsual: boolean;
  readonly outcome: R;
}

/** A parameter with its demonstrated values, and how many of them look alike. */
export interface Demonstrated<R> {
  readonly usual: number | "auto";
  readonly needed: Readonly<Record<string, number>>;
  readonly valueRuns: readonly ValueRun<R>[];
  /** Number of values that look like another one. */
  readonly alikeCount: number;
}

/** The parameter to demonstrate, with all values of its cycle and the cycle's context. */
export interface ShownPrompt {
  readonly cycle: Cycle;
  readonly q: string;
  readonly values: Readonly<Record<string, number | "auto">>;
  readonly given: Given;
}

/** Whether two runs differ visibly: in numbers, in the path, or in the part. */
function looksDifferent(a: RanProgram, b: RanProgram): boolean {
  const passes = ({ run }: RanProgram) => run.operations.reduce((sum, { plan }) => sum + plan.passes, 0);
  if (passes(a) !== passes(b) || Math.abs(a.run.seconds - b.run.seconds) >= LEAST_SEEN.seconds) return true;
  if (pathDistance(a.run, b.run) >= LEAST_SEEN.way) return true;
  const { part, residual, rz } = shownChange(a, b);
  return (
    part >= LEAST_SEEN.area || Math.abs(residual) >= LEAST_SEEN.area || (rz !== null && Math.abs(rz) >= LEAST_SEEN.rz)
  );
}

/** The issues of a run as text, to compare values without a path. */
const issuesKey = ({ run }: RanProgram) => JSON.stringify(run.issues.map(({ issue }) => issue));

/** Values without a path differ by their issues. */
const differs = (a: RanProgram, b: RanProgram): boolean => {
  const [one, other] = [makesPath(a), makesPath(b)];
  return one && other ? looksDifferent(a, b) : one !== other || issuesKey(a) !== issuesKey(b);
};

/** Intermediate values, for when one of the three makes no path or looks like another. */
function between(usual: number | "auto", decimals: number, ran: readonly ValueRun<unknown>[]): readonly number[] {
  if (usual === "auto") return [];
  const others = ran.flatMap(({ value }) => (value === "auto" || value === usual ? [] : [value]));
  return SHARES.flatMap((share) =>
    others.map((value) => rounded(Number((usual + share * (value - usual)).toFixed(decimals)))),
  );
}
/** Shares of the distance from the usual value to another one. */
const SHARES = [0.5, 1.5, 0.25, 0.1];

/** A small, a usual and a large value. */
const THREE = 3;

type Ran<R> = (values: Readonly<Record<string, number | "auto">>) => Promise<R | null>;

async function shownIn<R extends RanProgram>(
  { cycle, q, values: own }: ShownPrompt,
  { needed, usual: set, values }: Situation,
  run: Ran<R>,
): Promise<Demonstrated<R> | null> {
  const param = cycle.params[q];
  if (!param) return null;
  const {
    choices,
    range: [min, max],
  } = param;
  const usual = set ?? needed[q] ?? own[q] ?? param.example;
  const outcomes = new Map<number | "auto", R | null>();
  const at = async (value: number | "auto"): Promise<R | null> => {
    if (!outcomes.has(value)) outcomes.set(value, await run({ ...needed, [q]: value }));
    return outcomes.get(value) ?? null;
  };
  const first = await at(usual);
  if (!first || !makesPath(first)) return null;
  const ran: ValueRun<R>[] = [{ value: usual, isUsual: true, outcome: first }];
  const isNew = (outcome: R) => ran.every((other) => differs(outcome, other.outcome));
  const unseen: ValueRun<R>[] = [];
  const take = async (tried: Candidates["tried"]): Promise<boolean> => {
    let last: ValueRun<R> | null = null;
    for (const value of tried) {
      const outcome = await at(value);
      if (!outcome) continue;
      if ((choices || makesPath(outcome)) && isNew(outcome)) {
        ran.push({ value, isUsual: false, outcome });
        return true;
      }
      if (!last || !makesPath(last.outcome)) last = { value, isUsual: false, outcome };
    }
    if (last) unseen.push(last);
    return false;
  };
  for (const { tried, isUsual } of values) if (!isUsual) await take(tried);
  const wanted = choices ? values.length : THREE;
  if (!choices && ran.length < wanted) {
    for (const value of between(usual, finestOf(param), ran))
      if (ran.length < wanted && value >= min && value <= max && (await take([value]))) unseen.shift();
  }
  const missing = unseen.slice(0, wanted - ran.length);
  const order = ({ value }: ValueRun<R>) => values.findIndex(({ tried }) => tried.includes(value));
  const number = ({ value }: ValueRun<R>) => (value === "auto" ? 0 : value);
  const isFalling = typeof usual === "number" && usual < 0;
  const inOrder = [...ran, ...missing].toSorted((a, b) =>
    choices || usual === "auto" ? order(a) - order(b) : (number(a) - number(b)) * (isFalling ? -1 : 1),
  );
  return { usual, needed, valueRuns: inOrder, alikeCount: missing.length };
}

/**
 * Runs a cycle with values that demonstrate a parameter, in the first situation in which all of them differ visibly,
 * else in the one with the most visible values. Null where none makes a path. `run`: runs the cycle with some values
 * changed.
 */
export async function demonstrate<R extends RanProgram>(
  asked: ShownPrompt,
  run: Ran<R>,
): Promise<Demonstrated<R> | null> {
  let best: Demonstrated<R> | null = null;
  for (const situation of situationsOf(asked.cycle, asked.q, asked.values, asked.given)) {
    const shown = await shownIn(asked, situation, run);
    if (shown && (!best || worthOf(shown) > worthOf(best))) best = shown;
    if (shown && worthOf(shown) === shown.valueRuns.length) break;
  }
  return best;
}

/** How many values are visible; one without a path counts half, since it shows its error. */
const worthOf = ({ valueRuns, alikeCount }: Demonstrated<RanProgram>): number =>
  valueRuns.reduce((sum, { outcome }) => sum + (makesPath(outcome) ? 1 : 0.5), -alikeCount);
