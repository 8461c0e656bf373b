import { doneIn, firstNode, isCorner, nodesOf, type PlanNode, type Searching } from "./plan-node.ts";
import { followed } from "./search.ts";

/**
 * A plan whose steps come before those that a rule of the trade puts behind them, where that is better: what a step
 * takes long for has no part in the lookahead of another one, so that a slow one may have come too late. The first
 * `kept` steps stay. Yields before every try.
 */
export function* ordered(end: PlanNode, kept: number, s: Searching): Generator<PlanNode, PlanNode> {
  let best = end;
  for (let i = kept + 1; i < nodesOf(best).length; i += 1) {
    const nodes = nodesOf(best);
    const late = nodes[i]?.tried;
    if (!late || isCorner(late) || s.trade.after(late.action, doneIn(nodes[i - 1] ?? best)) === 0) continue;
    const to = nodes.findIndex((node, k) => k >= kept && k < i && s.trade.after(late.action, doneIn(node)) > 0);
    if (to < 0) continue;
    const others = nodes.slice(to).flatMap(({ tried }) => (tried && tried !== late ? [tried.action] : []));
    const earlier = yield* followed(nodes[to - 1] ?? firstNode(s), [late.action, ...others], s);
    if (s.ends.isBetter(earlier, best)) best = earlier;
  }
  return best;
}
