import { allActionsIn, nodesOf, type PlanNode, type Searching } from "./plan-node.ts";
import { followed } from "./search.ts";
import { wholeProgram } from "./whole-program.ts";

/** Whether the program of a plan holds as a whole: finishing may need the room that roughing farther has made. */
const isProved = (end: PlanNode, { request }: Searching): boolean =>
  wholeProgram(
    nodesOf(end).flatMap(({ tried }) => tried?.action ?? []),
    request,
  ).judged.verdict === "proved";

/**
 * A plan that roughs and finishes in one call where one tool does both with one cycle, and where that is better: only at
 * its end is it known that no other tool finishes. The first `kept` steps stay. Yields before every try.
 */
export function* inOneCall(end: PlanNode, kept: number, s: Searching): Generator<PlanNode, PlanNode> {
  let best = end;
  for (let i = kept; i < nodesOf(best).length; i += 1) {
    const nodes = nodesOf(best);
    const [rough, start] = [nodes[i]?.tried?.action, nodes[i]?.before];
    if (!rough || !start) continue;
    const later = nodes.slice(i + 1).flatMap(({ tried }) => tried?.action ?? []);
    for (const both of allActionsIn(start, s, rough.kind)) {
      if (!both.inOneCall || both.tool.T !== rough.tool.T || both.cycle !== rough.cycle) continue;
      const other = yield* followed(start, [both, ...later], s);
      if (other.seconds < best.seconds && s.ends.isBetter(other, best) && isProved(other, s)) best = other;
    }
  }
  return best;
}
