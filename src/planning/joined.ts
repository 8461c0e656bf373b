import { firstNode, nodesOf, type PlanNode, type Searching } from "./plan-node.ts";
import { followed } from "./search.ts";
import type { Action } from "./types.ts";

/** The same actions with the one at `from` moved to stand before or behind what is at `to`. */
function moved(actions: readonly Action[], from: number, to: number): readonly Action[] {
  const all = [...actions];
  const [action] = all.splice(from, 1);
  return action ? [...all.slice(0, to), action, ...all.slice(to)] : actions;
}

/** Places at which an action would stand beside another one with its tool, where it does not yet. */
function placesFor(actions: readonly Action[], i: number): readonly number[] {
  const isSame = (k: number) => actions[k]?.tool.T === actions[i]?.tool.T;
  if (isSame(i - 1) || isSame(i + 1)) return [];
  return actions.flatMap((_, k) => (k !== i && isSame(k) ? [k < i ? k + 1 : k - 1] : []));
}

/**
 * A plan in which steps that one tool does at two times are done at one, where that is better. The first `kept` steps
 * stay. Yields before every try.
 */
export function* joined(end: PlanNode, kept: number, s: Searching): Generator<PlanNode, PlanNode> {
  let best = end;
  for (let i = kept; i < nodesOf(best).length; i += 1) {
    const nodes = nodesOf(best);
    const actions = nodes.flatMap(({ tried }) => tried?.action ?? []);
    for (const to of placesFor(actions, i).filter((k) => k >= kept)) {
      const from = Math.min(i, to);
      const other = yield* followed(nodes[from]?.before ?? firstNode(s), moved(actions, i, to).slice(from), s);
      if (s.ends.isBetter(other, best)) best = other;
    }
  }
  return best;
}
