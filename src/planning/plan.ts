import { AnswerCache } from "../kernel/answer-cache.ts";
import { parse } from "../nc/parse.ts";
import type { Block } from "../nc/program.ts";
import { actionSources } from "./actions/index.ts";
import { explained } from "./explain.ts";
import { inOneCall } from "./in-one-call.ts";
import { LEAST_REGION } from "./open-regions.ts";
import { ordered } from "./ordered.ts";
import {
  allActionsIn,
  doneIn,
  Ends,
  firstNode,
  isParted,
  nodeBehind,
  type PlanNode,
  type Searching,
} from "./plan-node.ts";
import { residueOf } from "./residue.ts";
import { retooled } from "./retooled.ts";
import { beam, pruned } from "./search.ts";
import { inSequence, SEQUENCES } from "./sequences.ts";
import { secondClamping, withRear } from "./second-clamping.ts";
import { Trade } from "./trade-rules.ts";
import { Tries } from "./tries.ts";
import type { Action, ActionSource, PlanRequest } from "./types.ts";
import { wholeProgram, type WholeProgram } from "./whole-program.ts";
import type { ClampingChanges, PlanChanges, PlanProgress, WorkingPlan } from "./working-plan.ts";

/** Widths of the beam, one pass each: the first gives a plan at once, the others use its tries. */
const WIDTHS = [1, 3] as const;
/** Most tries of a search. */
const MOST = 1500;
/** Most operations that are left out because the whole program shows that they are at fault. */
const MOST_WITHOUT = 3;
/** Plans of cycles that a search remembers, bytes. */
const MEMORY = 50_000_000;

/** What a search is made again with whose plan did not hold as a whole. */
interface Again {
  /** Each on its whole stock. */
  readonly tries: Tries;
  /** Operations that are at fault, by their key. */
  readonly without: readonly string[];
}

/** The operation at fault in a whole program: each begins with its tool call. Undefined where it is none of them. */
function faultyIn({ text, judged }: WholeProgram, actions: readonly Action[]): Action | undefined {
  const block = judged.reasons[0]?.block ?? null;
  if (block === null) return undefined;
  const isCall = ({ statement }: Block) => statement.kind === "toolCall";
  const { blocks } = parse(text);
  const later = blocks.slice(block + 1).filter(isCall).length;
  return actions[actions.length - 1 - later];
}

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

/**
 * A plan to which none of the changes of single steps brings more: each may make another one worth it. What another way to
 * do a step leaves may be what a tool could take that was not needed before: while the part is still on its bar.
 */
function* improved(end: PlanNode, kept: number, s: Searching): Generator<PlanNode, PlanNode> {
  let [best, before]: [PlanNode, PlanNode | null] = [end, null];
  while (best !== before) {
    before = best;
    best = yield* pruned(best, s);
    best = yield* retooled(best, kept, s);
    best = yield* ordered(best, kept, s);
    const held = isParted(best) ? (best.before ?? best) : best;
    const further = best.left < LEAST_REGION ? best : yield* beam(held, 1, s);
    if (s.ends.isBetter(further, best)) best = further;
  }
  return best;
}

/**
 * Searches the working plan with the least time that leaves nothing a tool of the shop could take. Yields before every
 * try with the best plan so far; to cancel, stop asking. Pure and deterministic: the same request gives the same plan.
 * `again`: where the plan of a former search did not hold as a whole.
 */
export function* planning(
  asked: PlanRequest,
  changes: PlanChanges = {},
  sources: readonly ActionSource[] = actionSources,
  again: Again | null = null,
): Generator<PlanProgress, WorkingPlan> {
  const { instead, hand = {}, second: changesOfSecond = {} } = changes;
  const request: PlanRequest = { ...asked, shop: { ...asked.shop, memory: new AnswerCache(MEMORY) } };
  const s: Searching = {
    request,
    sources,
    tries: again?.tries ?? new Tries(request),
    trade: new Trade(request),
    known: new Map(),
    ends: new Ends(),
    hand: new Map(Object.entries(hand)),
    without: new Set(again?.without),
    most: MOST + (again?.tries.count ?? 0),
  };
  const byHand = new Set([...s.hand.keys(), ...(instead ? [instead.actionKey] : [])]);
  const from = yield* reported(replayed(changes, s), s, () => null);
  let best: PlanNode | null = null;
  for (const width of WIDTHS) {
    const found = yield* reported(beam(from, width, s), s, () => best);
    const shown: PlanNode = best ?? found;
    const end = yield* reported(improved(found, from.done.length, s), s, () => shown);
    if (!best || s.ends.isBetter(end, best)) best = end;
  }
  for (const kinds of SEQUENCES) {
    const found = yield* reported(inSequence(kinds, from, best ?? from, s), s, () => best);
    if (!best || !s.ends.isBetter(found, best)) continue;
    const shown: PlanNode = best;
    best = yield* reported(improved(found, from.done.length, s), s, () => shown);
  }
  const end = yield* reported(inOneCall(best ?? from, from.done.length, s), s, () => best);
  const whole = wholeProgram(doneIn(end), request);
  if (end.done.length > 0 && whole.judged.verdict !== "proved") {
    // Stock far from the place of an action made a difference after all.
    if (!again) return yield* planning(asked, changes, sources, { tries: new Tries(request, s.tries), without: [] });
    // A try knows only the contour of its own operation: what others keep is seen in the whole program.
    const faulty = faultyIn(whole, doneIn(end));
    if (faulty && !byHand.has(faulty.key) && again.without.length < MOST_WITHOUT)
      return yield* planning(asked, changes, sources, { tries: s.tries, without: [...again.without, faulty.key] });
  }
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
