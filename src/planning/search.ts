import { LEAST_REGION } from "./open-regions.ts";
import {
  actionsIn,
  allActionsIn,
  areRivals,
  changeBefore,
  doneIn,
  isCorner,
  nodeBehind,
  nodesOf,
  priceOf,
  type PlanNode,
  type Searching,
} from "./plan-node.ts";
import { isInPlace, isSameWork } from "./places.ts";
import { finishes, type Expected } from "./tries.ts";
import { ROUGHING, type Action } from "./types.ts";

/** An action in a state, with the cost so far and that of a tool change, s. */
interface Candidate {
  readonly node: PlanNode;
  readonly action: Action;
  readonly base: number;
}

/** A candidate that could work, with what is known of it and the least cost of a plan through it, s. */
interface Ranked {
  readonly candidate: Candidate;
  readonly known: Expected | null;
  readonly value: number;
}

/** What is still to be done in a state: all of it, and without corners. */
interface Waiting {
  readonly all: readonly Action[];
  readonly large: readonly Action[];
}
const NONE: Waiting = { all: [], large: [] };

/** An action without a known path may be this many times as quick as the quickest so far. */
const QUICKER = 2;

/** The candidates of one level of a search, and what is known of them. */
class Level {
  readonly candidates: readonly Candidate[];
  private readonly ofNode = new Map<PlanNode, readonly Action[]>();
  /** The order after a number of tries: only a try changes it. */
  private order: { readonly tries: number; readonly ranked: readonly Ranked[] } | null = null;

  constructor(
    nodes: readonly PlanNode[],
    private readonly s: Searching,
  ) {
    this.candidates = nodes.flatMap((node) => {
      const actions = actionsIn(node, s);
      this.ofNode.set(node, actions);
      const last = node.tried?.action ?? null;
      return actions
        .filter((action) => !this.isOtherOrder(node, action) && !this.isSmallerDrill(node, action))
        .map((action) => ({
          node,
          action,
          base: node.cost + changeBefore(action, last, s.request) + priceOf(action, doneIn(node), s.request),
        }));
    });
  }

  expected({ action, node }: Candidate): Expected | null {
    return this.s.tries.expectedOf(action, node);
  }

  /** The candidates that could work, the best first. */
  ranked(): readonly Ranked[] {
    const { count } = this.s.tries;
    if (this.order?.tries === count) return this.order.ranked;
    const waiting = new Map([...this.ofNode.keys()].map((node) => [node, this.waitingIn(node)]));
    const ranked = this.candidates
      .flatMap((candidate): Ranked[] => {
        const known = this.expected(candidate);
        if (known ? !known.works : this.isIdle(candidate)) return [];
        return [{ candidate, known, value: this.value(candidate, known, waiting.get(candidate.node) ?? NONE) }];
      })
      .sort((a, b) => a.value - b.value);
    this.order = { tries: count, ranked };
    return ranked;
  }

  /**
   * The least that a plan through a candidate costs as far as is known, s: nothing takes material faster than the
   * quickest cut so far, others wait, and what a finishing cut leaves has to be taken by the next better one.
   */
  private value(candidate: Candidate, known: Expected | null, { all, large }: Waiting): number {
    const { node, action, base } = candidate;
    const { tries, trade } = this.s;
    // A part that is off is in no chuck, even for corners.
    const early = base + trade.before(action, action.kind === "partOff" ? all : large);
    if (!known) {
      const bound = tries.boundOf(action, node);
      const seconds = Math.max(bound.seconds, tries.leastFor(bound.volume) / QUICKER);
      return early + seconds + trade.wear(action, seconds) + this.leastBehind(candidate, bound.volume);
    }
    const late = isCorner(known) ? 0 : trade.after(action, doneIn(node));
    const own = known.seconds + trade.wear(action, known.seconds);
    return early + late + own + this.leastBehind(candidate, known.volume) + this.restFor(candidate, known);
  }

  /** The least time for what is left when a candidate has taken a volume, s: only finishing takes the oversize. */
  private leastBehind({ node, action }: Candidate, taken: number): number {
    const left = Math.max(0, node.volume - taken);
    const skin = finishes(action) ? Math.max(0, node.skin - taken) : Math.min(node.skin, left);
    return this.s.tries.leastFor(left - skin) + this.s.tries.leastFor(skin, true);
  }

  private waitingIn(node: PlanNode): Waiting {
    const { tries } = this.s;
    const all = (this.ofNode.get(node) ?? []).filter((action) => tries.expectedOf(action, node)?.works !== false);
    const cutOf = (action: Action) => tries.expectedOf(action, node)?.cut ?? tries.boundOf(action, node).area;
    return { all, large: all.filter((action) => !isCorner({ cut: cutOf(action) })) };
  }

  /** Whether a candidate that was not tried surely takes nothing. */
  private isIdle({ action, node }: Candidate): boolean {
    return this.s.tries.boundOf(action, node).area < LEAST_REGION;
  }

  /** Whether a rival that was not tried could take what a finishing cut leaves. */
  takesMore({ action: rival, node }: Candidate, { action }: Candidate): boolean {
    const { tries } = this.s;
    return tries.boundOf(rival, node).area >= tries.boundOf(action, node).area + LEAST_REGION;
  }

  /** Time of the quickest rival that takes what a finishing cut leaves, s. */
  private restFor({ node, action }: Candidate, { cut }: Expected): number {
    if (ROUGHING.has(action.kind)) return 0;
    const better = (this.ofNode.get(node) ?? []).flatMap((rival) => {
      if (!areRivals(action, rival)) return [];
      const known = this.s.tries.expectedOf(rival, node);
      if (!known?.works || known.cut < cut + LEAST_REGION) return [];
      const price = priceOf(rival, [...doneIn(node), action], this.s.request);
      return [known.seconds + changeBefore(rival, action, this.s.request) + price];
    });
    return better.length > 0 ? Math.min(...better) : 0;
  }

  /** A drill takes nothing that a larger one, of the operator's table where the smaller one is, takes as deep. */
  private isSmallerDrill(node: PlanNode, { kind, tool, place }: Action): boolean {
    const { tries, request } = this.s;
    const isUsual = (T: number) => request.usualTools?.includes(T) ?? false;
    return (
      kind === "drill" &&
      (this.ofNode.get(node) ?? []).some(
        (larger) =>
          larger.kind === kind &&
          larger.place.high > place.high &&
          larger.place.rear <= place.rear &&
          (isUsual(tool.T) || !isUsual(larger.tool.T)) &&
          tries.expectedOf(larger, node)?.works !== false,
      )
    );
  }

  /** Two actions of one tool and kind in places apart lead to the same in either order: from the front is enough. */
  private isOtherOrder(node: PlanNode, action: Action): boolean {
    const last = node.tried?.action;
    if (!last || !node.before || last.tool.T !== action.tool.T || last.kind !== action.kind) return false;
    if (isInPlace(last, action) || action.place.front < last.place.front) return false;
    if (action.place.front === last.place.front && action.key >= last.key) return false;
    return actionsIn(node.before, this.s, action.kind).some(({ key }) => key === action.key);
  }
}

/**
 * The first of the candidates that has to be tried to know the best ones: it could be one itself, or could be what a
 * finishing cut leaves to do. Null where all are known.
 */
function untried(level: Level, width: number): Candidate | null {
  const all = level.ranked();
  for (const { candidate, known } of all.slice(0, width)) {
    if (!known) return candidate;
    if (ROUGHING.has(candidate.action.kind)) continue;
    const rival = all.find(
      (other) =>
        !other.known &&
        other.candidate.node === candidate.node &&
        areRivals(other.candidate.action, candidate.action) &&
        level.takesMore(other.candidate, candidate),
    );
    if (rival) return rival.candidate;
  }
  return null;
}

/** The best states behind the candidates of a level, each stock once. Yields before every try. */
function* nextLevel(level: Level, width: number, s: Searching): Generator<PlanNode, readonly PlanNode[]> {
  for (let next = untried(level, width); next && s.tries.count < s.most; next = untried(level, width)) {
    yield next.node;
    s.tries.of(next.action, next.node);
  }
  const reached = new Map<string, PlanNode>();
  const seen = new Set<Candidate>();
  while (reached.size < width && s.tries.count < s.most) {
    const next = level.ranked().find(({ candidate }) => !seen.has(candidate));
    if (!next) break;
    const { candidate, known } = next;
    if (known) {
      seen.add(candidate);
      yield* reach(candidate, reached, s);
    } else {
      yield candidate.node;
      s.tries.of(candidate.action, candidate.node);
    }
  }
  if (reached.size > 0) return [...reached.values()];
  // What failed may work now that the stock beside its place is gone.
  for (const candidate of level.candidates) {
    if (reached.size >= width || s.tries.count >= s.most) break;
    const known = level.expected(candidate);
    if (known && !known.works && known.cut >= LEAST_REGION) yield* reach(candidate, reached, s);
  }
  return [...reached.values()];
}

/** Adds the state behind a candidate where it works and its stock is new. */
function* reach({ action, node }: Candidate, reached: Map<string, PlanNode>, s: Searching): Generator<PlanNode, void> {
  yield node;
  const tried = s.tries.of(action, node);
  if (!tried.works) return;
  const behind = nodeBehind(node, tried, s);
  const key = [action.tool.T, ...[...behind.threads].toSorted(), s.tries.keyOf(behind.stock)].join();
  const same = reached.get(key);
  if (!same || behind.cost < same.cost) reached.set(key, behind);
}

/**
 * Beam search from one state: of the states behind each step the `width` best go on. Returns the best end that it
 * found.
 */
export function* beam(from: PlanNode, width: number, s: Searching): Generator<PlanNode, PlanNode> {
  let [nodes, best]: [readonly PlanNode[], PlanNode | null] = [[from], null];
  while (nodes.length > 0) {
    const next: readonly PlanNode[] = yield* nextLevel(new Level(nodes, s), width, s);
    const ended = next.length === 0 ? nodes : nodes.filter((node) => node.left < LEAST_REGION);
    for (const node of ended) if (!best || s.ends.isBetter(node, best)) best = node;
    nodes = next;
  }
  return best ?? from;
}

/**
 * A plan without the steps that a later one makes needless, as a finishing cut before a better one. Yields before every
 * try.
 */
export function* pruned(end: PlanNode, s: Searching): Generator<PlanNode, PlanNode> {
  let best = end;
  for (let i = end.done.length - 2; i >= 0; i -= 1) {
    const nodes = nodesOf(best);
    const action = nodes[i]?.tried?.action;
    const later = nodes.slice(i + 1).flatMap(({ tried }) => tried?.action ?? []);
    const start = nodes[i]?.before;
    if (!action || !start || !later.some((a) => areRivals(a, action))) continue;
    const without = yield* followed(start, later, s);
    if (s.ends.isBetter(without, best)) best = without;
  }
  return best;
}

/** Whether an action does with the same tool and cycle more or less of another. */
const isLike = (a: Action, b: Action): boolean =>
  a.kind === b.kind && a.cycle === b.cycle && a.tool.T === b.tool.T && isInPlace(a, b);

/** The state behind actions one after the other, without those that do not work there. */
export function* followed(from: PlanNode, actions: readonly Action[], s: Searching): Generator<PlanNode, PlanNode> {
  let node = from;
  for (const wanted of actions) {
    const open = actionsIn(node, s, wanted.kind);
    const action =
      allActionsIn(node, s, wanted.kind).find(({ key }) => key === wanted.key) ??
      open.find((a) => isLike(a, wanted)) ??
      open.find((a) => isSameWork(a, wanted) && actions.some(({ tool }) => tool.T === a.tool.T));
    if (!action) continue;
    yield node;
    const tried = s.tries.of(action, node);
    if (tried.works) node = nodeBehind(node, tried, s);
  }
  return node;
}
