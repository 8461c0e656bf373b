import { areaOf } from "../kernel/area/area.ts";
import { difference, opened } from "../kernel/area/clip.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import { LEAST_REGION } from "./open-regions.ts";
import { turnedVolume } from "./stock-key.ts";
import { penaltyAfter, penaltyBefore } from "./trade-rules.ts";
import type { Tries } from "./tries.ts";
import type { Action, ActionSource, PlanRequest, PlanState, TriedAction } from "./types.ts";
import type { PlanProgress } from "./working-plan.ts";

/** A state of the search with the way to it. */
export interface Node extends PlanState {
  readonly before: Node | null;
  /** The step that led here; null at the beginning. */
  readonly tried: TriedAction | null;
  /** Cost so far, s: time, tool changes, rules; and the time alone. */
  readonly cost: number;
  readonly seconds: number;
  /** Material outside the finished part: mm² of the half plane, and mm³. */
  readonly left: number;
  readonly volume: number;
  /** Actions that could be next; made when they are asked for. */
  readonly next: () => readonly Action[];
}

/** What a search works with. */
export interface Searching {
  readonly request: PlanRequest;
  readonly sources: readonly ActionSource[];
  readonly tries: Tries;
  /** Actions with values by hand: each takes the place of the action with its key and of others in its place. */
  readonly locked: readonly Action[];
  /** Bound of tries. */
  readonly most: number;
}

const isBeside = (a: Action, b: Action) =>
  a.place.front <= b.place.rear ||
  b.place.front <= a.place.rear ||
  a.place.high <= b.place.low ||
  b.place.high <= a.place.low;

/** Actions that could be next in a state, those by hand in place of what they replace. */
function actionsIn(state: PlanState, { request, sources, locked }: Searching): readonly Action[] {
  const { withoutCycles, withoutTools } = request;
  const all = sources
    .flatMap((source) => source.actions(state, request))
    .filter(
      ({ cycle, tool, threads }) =>
        (cycle === null || !withoutCycles.includes(cycle)) &&
        !withoutTools.includes(tool.T) &&
        (threads.length === 0 || threads.some((t) => !state.threads.has(t))),
    );
  if (locked.length === 0) return all;
  const byKey = new Map(locked.map((l) => [l.key, l]));
  const own = all.map((a) => byKey.get(a.key) ?? a);
  const here = own.filter((a) => byKey.get(a.key) === a);
  return own.filter((a) => here.includes(a) || !here.some((l) => l.kind === a.kind && !isBeside(l, a)));
}

/** Time of a tool change on the machine, s. */
export const changeTime = ({ shop: { machine }, rules }: PlanRequest): number =>
  machine?.toolChange ?? rules.toolChange;

/** Time of the tool change before an action, s. */
export const changeBefore = ({ tool }: Action, before: Action | null, request: PlanRequest): number =>
  before?.tool.T === tool.T ? 0 : changeTime(request);

const made = (s: Searching, state: PlanState, rest: Omit<Node, keyof PlanState | "left" | "volume" | "next">): Node => {
  const open = opened(difference(state.stock, s.request.part.rings), SLIVER);
  let actions: readonly Action[] | null = null;
  return {
    ...state,
    ...rest,
    left: areaOf(open),
    volume: turnedVolume(open),
    next: () => (actions ??= actionsIn(state, s)),
  };
};

/** The state before the first action. */
export const firstNode = (s: Searching): Node =>
  made(s, { stock: s.request.blank, done: [], threads: new Set() }, { before: null, tried: null, cost: 0, seconds: 0 });

/** The state behind an action that works. */
export function nodeBehind(s: Searching, node: Node, tried: TriedAction): Node {
  const { action, stock, seconds: cutting } = tried;
  const seconds = cutting + changeBefore(action, node.tried?.action ?? null, s.request);
  const penalty = penaltyAfter(
    action,
    node.done.map((d) => d.action),
    s.request,
  );
  return made(
    s,
    { stock, done: [...node.done, tried], threads: new Set([...node.threads, ...action.threads]) },
    { before: node, tried, cost: node.cost + seconds + penalty, seconds: node.seconds + seconds },
  );
}

/** Whether nothing is left to do. */
const isDone = (node: Node, { request }: Searching): boolean =>
  node.left < LEAST_REGION &&
  !node.next().some(({ kind, threads }) => threads.length > 0 || (kind === "partOff" && request.partsOff));

/** Differences of two ends of a search in the order in which they count; negative: the first is better. */
export function compareEnds(a: Node, b: Node): number {
  const parted = (n: Node) => Number(n.done.some(({ action }) => action.kind === "partOff"));
  const left = a.left - b.left;
  return (
    parted(b) - parted(a) ||
    b.threads.size - a.threads.size ||
    (Math.abs(left) < LEAST_REGION ? 0 : left) ||
    a.cost - b.cost
  );
}

/** An action in a state with the least that a whole plan through it can cost, as far as is known. */
interface Candidate {
  readonly node: Node;
  readonly action: Action;
  readonly bound: number;
  /** It failed where the stock in its place was the same. */
  readonly hasFailed: boolean;
}

function candidatesOf(node: Node, s: Searching): readonly Candidate[] {
  const { tries, request } = s;
  const all = node.next();
  const expected = new Map(all.map((a) => [a, tries.expectedOf(a, node)]));
  const waiting = all.filter((a) => expected.get(a)?.works !== false);
  const done = node.done.map((d) => d.action);
  return all.map((action) => {
    const known = expected.get(action);
    const base =
      node.cost +
      changeBefore(action, node.tried?.action ?? null, request) +
      penaltyAfter(action, done, request) +
      penaltyBefore(action, waiting, request);
    // Nothing takes material faster than the best action so far.
    const rest = known?.works ? known.seconds + restOf(node.volume - known.volume, tries) : restOf(node.volume, tries);
    return { node, action, bound: base + rest, hasFailed: known?.works === false };
  });
}

/** Least time for a volume, s. */
const restOf = (volume: number, { rate }: Tries): number => (rate > 0 ? Math.max(0, volume) / rate : 0);

/** Skips an order of two actions of one tool in places apart when the other order was open, too: it leads to the same. */
function isOtherOrder({ node, action }: Candidate): boolean {
  const last = node.tried?.action;
  return (
    last !== undefined &&
    last.tool.T === action.tool.T &&
    last.kind === action.kind &&
    isBeside(last, action) &&
    (action.place.front > last.place.front || (action.place.front === last.place.front && action.key < last.key)) &&
    (node.before?.next().some(({ key }) => key === action.key) ?? false)
  );
}

/**
 * Beam search from one state: of the states behind each step the `width` best go on. Yields before every try. Returns
 * the best end that it found.
 */
export function* beam(s: Searching, from: Node, width: number): Generator<Node, Node> {
  let [level, best]: [readonly Node[], Node | null] = [[from], null];
  const take = (end: Node) => {
    if (!best || compareEnds(end, best) < 0) best = end;
  };
  while (level.length > 0 && s.tries.count < s.most) {
    const ends = level.filter((node) => isDone(node, s));
    ends.forEach(take);
    const open = level.filter((node) => !ends.includes(node));
    const all = open
      .flatMap((node) => candidatesOf(node, s))
      .toSorted((a, b) => Number(a.hasFailed) - Number(b.hasFailed) || a.bound - b.bound);
    const next = new Map<string, { readonly node: Node; readonly value: number }>();
    const kept = () => [...next.values()].toSorted((a, b) => a.value - b.value).slice(0, width);
    for (const candidate of all) {
      const worst = kept()[width - 1]?.value ?? Infinity;
      if (candidate.bound >= worst || (candidate.hasFailed && next.size > 0)) break;
      if (s.tries.count >= s.most) break;
      if (isOtherOrder(candidate)) continue;
      const { node, action } = candidate;
      yield node;
      const tried = s.tries.of(action, node);
      if (!tried.works) continue;
      const behind = nodeBehind(s, node, tried);
      const waits = penaltyBefore(
        action,
        node.next().filter((a) => s.tries.expectedOf(a, node)?.works !== false),
        s.request,
      );
      const value = behind.cost + restOf(behind.volume, s.tries) + waits;
      const key = `${action.tool.T} ${[...behind.threads].sort().join()} ${s.tries.keyOf(behind.stock)}`;
      const same = next.get(key);
      if (!same || value < same.value) next.set(key, { node: behind, value });
    }
    const reached = kept().map(({ node }) => node);
    // Where nothing works any more, a plan ends.
    open
      .filter((node) => !reached.some(({ before }) => before === node))
      .filter(() => next.size === 0)
      .forEach(take);
    level = reached;
  }
  level.forEach(take);
  return best ?? from;
}

/** What a search tells about where it is. */
export const progressOf = ({ done, stock, seconds, left }: Node, { tries, most }: Searching): PlanProgress => ({
  tries: tries.count,
  most,
  done,
  stock,
  seconds,
  left,
});
