import { print, type Program } from "../../nc/program.ts";
import { changedProgram, type ChangeKind } from "./change.ts";
import { fitter } from "./fits.ts";
import { baselineOf, judged, type Baseline } from "./judge.ts";
import { KINDS } from "./kinds.ts";
import { pairsOf } from "./pairs.ts";
import { together } from "./together.ts";
import { worthOf } from "./measure.ts";
import type { BetterWay, Candidate } from "./way.ts";
import { situationOf, type Attempt, type Conditions, type Trial } from "./situation.ts";

export type { BetterWay, Candidate } from "./way.ts";

/** Tries of one search: fewer for a long program, whose blocks in all tries are limited. */
const MOST_TRIES = 80;
const LEAST_TRIES = 12;
const MOST_EDITED = 40_000;
/** Most blocks of a program that is searched. */
const MOST_BLOCKS = 20_000;

/** A search before its tries: what a way is judged against, and the changes, the most promising first. */
export interface Search {
  /** The program. */
  readonly text: string;
  readonly baseline: Baseline;
  readonly candidates: readonly Candidate[];
}

/** Finds what could be better in a program with its result. */
export function searchOf(program: Program, attempt: Attempt, conditions: Conditions): Search {
  const baseline = baselineOf(attempt, conditions.material);
  if (program.blocks.length > MOST_BLOCKS) return { text: print(program), baseline, candidates: [] };
  const situation = situationOf(program, attempt, conditions);
  const fits = fitter(situation);
  const text = print(program);
  const each = Object.values(KINDS).flatMap((changesOf) => changesOf(situation, fits));
  const changes = [...each, ...together(program, each)].toSorted((a, b) => b.expected - a.expected);
  const most = Math.max(LEAST_TRIES, Math.min(MOST_TRIES, Math.floor(MOST_EDITED / program.blocks.length)));
  const candidates = new Map<string, Candidate>();
  for (const change of changes.slice(0, 2 * most)) {
    if (candidates.size >= most) break;
    const changed = changedProgram(change);
    const made = changed ? print(changed) : text;
    if (made !== text && !candidates.has(made)) candidates.set(made, { subject: change.subject, text: made });
  }
  return { text, baseline, candidates: [...candidates.values()] };
}

/** The result of a try; null unless it is better. `trial`: the candidate's text, run. */
export function triedWay(candidate: Candidate, baseline: Baseline, trial: Trial): BetterWay | null {
  const found = judged(baseline, trial);
  if (!found) return null;
  const { measure: before } = baseline;
  const worth = worthOf(before, found.measure, found.gains);
  return worth > 0 ? { ...candidate, before, after: found.measure, gains: found.gains, worth } : null;
}

/** Kinds that give an operation to another tool or cycle: of those only one can be used. */
const REPLACING: ReadonlySet<ChangeKind> = new Set(["fewerTools", "otherTool", "otherCycle", "restOperation"]);
/** Whether a way that was found contains a change that is still to be tried. */
const isCovered = ({ subject }: Candidate, ways: readonly BetterWay[]): boolean =>
  ways.some(
    ({ subject: { kind, tool, cycle, value, units } }) =>
      units.length > subject.units.length &&
      value !== undefined &&
      kind === subject.kind &&
      tool === subject.tool &&
      cycle === subject.cycle &&
      value.at === subject.value?.at &&
      subject.units.every((unit) => units.includes(unit)),
  );

/** Ways with one effect: the same change of the same operations, or alternatives to each other. */
const effectOf = ({ subject: { kind, units, tools = [], instead = 0 }, gains }: BetterWay): string =>
  kind === "fewerTools"
    ? JSON.stringify([kind, [...tools, instead].toSorted((a, b) => a - b)])
    : JSON.stringify([REPLACING.has(kind) ? "replacing" : kind, units, gains[0]]);
const resultOf = ({ after }: BetterWay): string => JSON.stringify(after);

/** The ways to offer, the best first: of several with one effect or one result only the best. */
export function bestWays(ways: readonly BetterWay[]): readonly BetterWay[] {
  const sorted = ways.toSorted((a, b) => b.worth - a.worth || a.text.length - b.text.length);
  const taken = new Set<string>();
  return sorted.filter((way) => {
    const keys = [effectOf(way), resultOf(way)];
    if (keys.some((key) => taken.has(key))) return false;
    for (const key of keys) taken.add(key);
    return true;
  });
}

/** A change to try next: how many were tried, of how many, and what was better. */
export interface NextTry {
  readonly candidate: Candidate;
  readonly tried: number;
  readonly of: number;
  readonly ways: readonly BetterWay[];
}

/**
 * The tries of a search, one per step: takes what came of each, and returns the ways to offer. Behind the single changes
 * come pairs of the best ones, which have to be worth more than either.
 */
export function* triesOf({ text, candidates }: Search): Generator<NextTry, readonly BetterWay[], BetterWay | null> {
  const ways: BetterWay[] = [];
  for (const [tried, candidate] of candidates.entries()) {
    if (isCovered(candidate, ways)) continue;
    const way = yield { candidate, tried, of: candidates.length, ways };
    if (way) ways.push(way);
  }
  const [most, pairs] = [Math.max(0, ...ways.map(({ worth }) => worth)), pairsOf(text, bestWays(ways))];
  for (const [i, candidate] of pairs.entries()) {
    const of = candidates.length + pairs.length;
    const way = yield { candidate, tried: candidates.length + i, of, ways };
    if (way && way.worth > most) ways.push(way);
  }
  return bestWays(ways);
}

/** A whole search, one try per step: yields what is tried, and returns the ways to offer. */
export function* betterWays(
  program: Program,
  attempt: Attempt,
  trial: (text: string) => Trial,
  conditions: Conditions,
): Generator<NextTry, readonly BetterWay[]> {
  const search = searchOf(program, attempt, conditions);
  const tries = triesOf(search);
  for (let next = tries.next(null); ;) {
    if (next.done) return next.value;
    yield next.value;
    const { candidate } = next.value;
    next = tries.next(triedWay(candidate, search.baseline, trial(candidate.text)));
  }
}
