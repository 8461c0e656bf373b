import { boxAround, inBox } from "../kernel/area/box.ts";
import { threadsOf } from "./actions/thread.ts";
import { LEAST_REGION } from "./open-regions.ts";
import {
  actionsIn,
  changeBefore,
  doneIn,
  isParted,
  nodeBehind,
  priceOf,
  type PlanNode,
  type Searching,
} from "./plan-node.ts";
import { turnedVolume } from "./stock-key.ts";
import { ACTION_KINDS, type Action, type ActionKind, type PlanRequest } from "./types.ts";

/** Usual sequences of the trade: kinds in their usual order, and grooves and undercuts behind finishing. */
export const SEQUENCES: readonly (readonly ActionKind[])[] = [
  ACTION_KINDS,
  [
    "face",
    "centre",
    "drill",
    "roughOutside",
    "restRough",
    "roughInside",
    "finishOutside",
    "finishInside",
    "recess",
    "undercut",
    "thread",
    "partOff",
  ],
];

/** Whether a plan makes all of a part. */
const isWhole = (end: PlanNode, { part, partsOff }: PlanRequest): boolean =>
  end.left === 0 &&
  end.threads.size === threadsOf(part.outside).length + threadsOf(part.inside).length &&
  (isParted(end) || !partsOff);

/** The least time for what is left in a state, s: the rest of a bar is parted off. */
function leastBehind({ open }: PlanNode, { tries, request: { part } }: Searching): number {
  const { left } = boxAround(part.rings);
  return tries.leastFor(turnedVolume(inBox(open, { left, right: Infinity, low: 0, high: Infinity })));
}

/** Whether an action that was not tried surely takes nothing, or makes the plan dearer than `most`. */
function isHopeless(action: Action, node: PlanNode, most: number, s: Searching): boolean {
  const { area, seconds } = s.tries.boundOf(action, node);
  const before = changeBefore(action, node.tried?.action ?? null, s.request) + priceOf(action, doneIn(node), s.request);
  return area < LEAST_REGION || node.cost + before + Math.max(seconds, leastBehind(node, s)) > most;
}

/**
 * The plan of a sequence: of each kind the first way that works, as often as one does. Without what
 * makes it dearer than a known plan that makes all. Yields before every try.
 */
export function* inSequence(
  kinds: readonly ActionKind[],
  from: PlanNode,
  known: PlanNode,
  s: Searching,
): Generator<PlanNode, PlanNode> {
  const most = isWhole(known, s.request) ? known.cost : Infinity;
  let node = from;
  for (const kind of kinds)
    for (;;) {
      const works: PlanNode | null = yield* firstOf(kind, node, most, s);
      if (!works) break;
      node = works;
    }
  return node;
}

/** The state behind the first way of a kind that works; null where none does. */
function* firstOf(kind: ActionKind, node: PlanNode, most: number, s: Searching): Generator<PlanNode, PlanNode | null> {
  for (const action of actionsIn(node, s, kind).filter((a) => a.kind === kind)) {
    if (s.tries.count >= s.most) return null;
    if (isHopeless(action, node, most, s)) continue;
    yield node;
    const tried = s.tries.of(action, node);
    if (tried.works) return nodeBehind(node, tried, s);
  }
  return null;
}
