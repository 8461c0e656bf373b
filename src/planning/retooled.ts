import { joined } from "./joined.ts";
import { LEAST_REGION } from "./open-regions.ts";
import {
  actionsIn,
  changeBefore,
  compareStates,
  doneIn,
  nodeBehind,
  nodesOf,
  priceOf,
  type PlanNode,
  type Searching,
} from "./plan-node.ts";
import { isSameWork } from "./places.ts";
import { followed } from "./search.ts";
import type { Action } from "./types.ts";

/** Steps one after the other with one tool: the indices of the first and of the one behind the last. */
function runsOf(nodes: readonly PlanNode[]): readonly (readonly [from: number, to: number])[] {
  const toolOf = (i: number) => nodes[i]?.tried?.action.tool.T;
  const starts = nodes.flatMap((_, i) => (i === 0 || toolOf(i) !== toolOf(i - 1) ? [i] : []));
  return starts.map((from, i) => [from, starts[i + 1] ?? nodes.length]);
}

/** The state behind the same work with another tool: of several ways the one that takes most. Null where it has none. */
function* withTool(
  from: PlanNode,
  run: readonly Action[],
  T: number,
  s: Searching,
): Generator<PlanNode, PlanNode | null> {
  let node = from;
  for (const wanted of run) {
    let best: PlanNode | null = null;
    for (const action of actionsIn(node, s, wanted.kind).filter((a) => a.tool.T === T && isSameWork(a, wanted))) {
      yield node;
      const tried = s.tries.of(action, node);
      if (!tried.works) continue;
      const behind = nodeBehind(node, tried, s);
      if (!best || compareStates(behind, best) < 0) best = behind;
    }
    if (!best) return null;
    node = best;
  }
  return node;
}

/**
 * Whether a plan with another tool up to here can be better behind it: that takes more, or its tool is in the spindle
 * already for what follows, was paid for, or can be put together with other work of it; else the rest takes as long as
 * it did.
 */
function canGain(node: PlanNode, before: PlanNode, rest: readonly Action[], { request }: Searching): boolean {
  if (node.left < before.left - LEAST_REGION) return true;
  const [last, next] = [node.tried?.action ?? null, rest[0]];
  const change = next
    ? changeBefore(next, before.tried?.action ?? null, request) - changeBefore(next, last, request)
    : 0;
  if (!last) return true;
  const isLast = ({ tool }: Action) => tool.T === last.tool.T;
  const price = rest.some(isLast) ? priceOf(last, doneIn(before), request) : 0;
  const together = [...doneIn(before), ...rest].some(isLast) ? changeBefore(last, null, request) : 0;
  return node.cost < before.cost + change + price + together;
}

/**
 * A plan in which the work that one tool does at a stretch is done by another one where the whole is better for it: a
 * beam keeps few states with the tool that only a later step needs. The first `kept` steps stay. Yields before every try.
 */
export function* retooled(end: PlanNode, kept: number, s: Searching): Generator<PlanNode, PlanNode> {
  let best = end;
  for (let i = runsOf(nodesOf(best)).length - 1; i >= 0; i -= 1) {
    const nodes = nodesOf(best);
    const [from, to] = runsOf(nodes)[i] ?? [0, 0];
    const [start, first, before] = [nodes[from]?.before, nodes[from]?.tried?.action, nodes[to - 1]];
    if (!start || !first || !before || from < kept) continue;
    const actions = nodes.flatMap(({ tried }) => tried?.action ?? []);
    const tools = new Set(actionsIn(start, s, first.kind).flatMap((a) => (isSameWork(a, first) ? [a.tool.T] : [])));
    for (const T of tools) {
      if (s.tries.count >= s.most) return best;
      const node = yield* withTool(start, actions.slice(from, to), T, s);
      if (!node || !canGain(node, before, actions.slice(to), s)) continue;
      const then = yield* followed(node, actions.slice(to), s);
      const other = yield* joined(then, kept, s);
      if (s.ends.isBetter(other, best)) best = other;
    }
  }
  return best;
}
