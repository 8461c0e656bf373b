import { AnswerCache } from "../kernel/answer-cache.ts";
import { parse } from "../nc/parse.ts";
import { actionSources } from "./actions/index.ts";
import { explained } from "./explain.ts";
import { inOneCall } from "./in-one-call.ts";
import { ordered } from "./ordered.ts";
import {
  allActionsIn,
  compareEnds,
  firstNode,
  nodeBehind,
  nodesOf,
  type PlanNode,
  type Searching,
} from "./plan-node.ts";
import { residueOf } from "./residue.ts";
import { retooled } from "./retooled.ts";
import { beam, pruned } from "./search.ts";
import { secondClamping, withRear } from "./second-clamping.ts";
import { Trade } from "./trade-rules.ts";
import { Tries } from "./tries.ts";
import type { ActionSource, PlanRequest } from "./types.ts";
import { wholeProgram } from "./whole-program.ts";
import type { ClampingChanges, PlanChanges, PlanProgress, WorkingPlan } from "./working-plan.ts";

/** Widths of the beam, one pass each: the first gives a plan at once, the others use its tries. */
const WIDTHS = [1, 3] as const;
/** Most tries of a search. */
const MOST = 1500;
/** Plans of cycles that a search remembers, bytes. */
const MEMORY = 50_000_000;

/** The state behind the steps that an operator keeps or has chosen, as far as they are possible and work. */
function* replayed({ keep = [], instead }: ClampingChanges, s: Searching): Generator<PlanNode, PlanNode> {
  let node = firstNode(s);
  for (const key of instead ? [...keep.slice(0, instead.at), instead.actionKey] : keep) {
    const action = allActionsIn(node, s).find((a) => a.key === key);
    if (!action) return node;
    yield node;
    const tried = s.tries.of(action, node);
    if (!tried.works) return node;
    node = nodeBehind(node, tried, s);
  }
  return node;
}

/** A plan to which none of the changes of single steps brings more: each may make another one worth it. */
function* improved(end: PlanNode, kept: number, s: Searching): Generator<PlanNode, PlanNode> {
  let [best, before]: [PlanNode, PlanNode | null] = [end, null];
  while (best !== before) {
    before = best;
    best = yield* pruned(best, s);
    best = yield* retooled(best, kept, s);
    best = yield* ordered(best, kept, s);
  }
  return best;
}

/**
 * Searches the working plan with the least time that leaves nothing a tool of the shop could take. Yields before every
 * try with the best plan so far; to cancel, stop asking. Pure and deterministic: the same request gives the same plan.
 * `former`: tries of a search whose plan did not hold as a whole.
 */
export function* planning(
  asked: PlanRequest,
  changes: PlanChanges = {},
  sources: readonly ActionSource[] = actionSources,
  former: Tries | null = null,
): Generator<PlanProgress, WorkingPlan> {
  const { instead, hand = {}, second: changesOfSecond = {} } = changes;
  const request: PlanRequest = { ...asked, shop: { ...asked.shop, memory: new AnswerCache(MEMORY) } };
  const s: Searching = {
    request,
    sources,
    tries: new Tries(request, former),
    trade: new Trade(request),
    known: new Map(),
    hand: new Map(Object.entries(hand)),
    most: MOST + (former?.count ?? 0),
  };
  const byHand = new Set([...s.hand.keys(), ...(instead ? [instead.actionKey] : [])]);
  const from = yield* reported(replayed(changes, s), s, () => null);
  let best: PlanNode | null = null;
  for (const width of WIDTHS) {
    const found = yield* reported(beam(from, width, s), s, () => best);
    const shown: PlanNode = best ?? found;
    const end = yield* reported(improved(found, from.done.length, s), s, () => shown);
    if (!best || compareEnds(end, best) < 0) best = end;
  }
  const end = yield* reported(inOneCall(best ?? from, from.done.length, s), s, () => best);
  const whole = wholeProgram(
    nodesOf(end).flatMap(({ tried }) => tried?.action ?? []),
    request,
  );
  // Stock far from the place of an action made a difference after all.
  if (end.done.length > 0 && whole.judged.verdict !== "proved" && !former)
    return yield* planning(asked, changes, sources, s.tries);
  const steps = yield* reported(explained(end, byHand, s), s, () => end);
  const found = yield* reported(residueOf(end, whole.stock, s), s, () => end);
  // What is left may be for the other end; a second clamping has no third.
  const hasRegion = found.some(({ region }) => region !== null);
  const other = hasRegion && !request.begun ? secondClamping(asked, end, parse(whole.text)) : null;
  const turned = other && (yield* unseen(planning(other, changesOfSecond, sources), progressOf(end, s, true)));
  const second = turned && turned.steps.length > 0 ? turned : null;
  const residue = second ? withRear(found, second, request.part) : found;
  return {
    ...whole,
    setup: { part: request.part, blank: request.blank, clamping: request.clamping },
    steps,
    residue,
    isComplete: whole.judged.verdict === "proved" && residue.every(({ why }) => why === "rear" || why === "clamping"),
    second,
    tries: s.tries.count,
  };
}

/** Turns the states that a part of the search looks at into its progress; `best`: the plan to show instead. */
function* reported<T>(
  part: Generator<PlanNode, T>,
  s: Searching,
  best: () => PlanNode | null,
): Generator<PlanProgress, T> {
  for (;;) {
    const next = part.next();
    if (next.done) return next.value;
    const whole = best();
    yield progressOf(whole ?? next.value, s, whole !== null);
  }
}

/** A search whose stock is turned end for end: it tells where the first one ended. */
function* unseen<T>(search: Generator<PlanProgress, T>, told: PlanProgress): Generator<PlanProgress, T> {
  for (;;) {
    const next = search.next();
    if (next.done) return next.value;
    yield told;
  }
}

/** What a search tells about where it is. */
const progressOf = (
  { done, stock, seconds, left }: PlanNode,
  { tries, most }: Searching,
  isWhole: boolean,
): PlanProgress => ({
  tries: tries.count,
  most,
  isWhole,
  done,
  stock,
  seconds,
  left,
});
