import { areaOf } from "../kernel/area/area.ts";
import { inBox } from "../kernel/area/box.ts";
import { difference, opened } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import { withHandValues } from "./hand-values.ts";
import { LEAST_REGION } from "./open-regions.ts";
import { turnedVolume } from "./stock-key.ts";
import type { Trade } from "./trade-rules.ts";
import type { Tries } from "./tries.ts";
import type { Action, ActionSource, HandValues, PlanRequest, PlanState, TriedAction } from "./types.ts";

/** A state of the search with the way to it. */
export interface PlanNode extends PlanState {
  readonly before: PlanNode | null;
  /** The step that led here; null at the beginning. */
  readonly tried: TriedAction | null;
  /** Cost so far, s: time, tool changes, rules; and the time alone. */
  readonly cost: number;
  readonly seconds: number;
  /** Material outside the finished part: mm² of the half plane, and mm³. */
  readonly left: number;
  readonly volume: number;
  readonly open: readonly Ring[];
}

/** What a search works with. */
export interface Searching {
  readonly request: PlanRequest;
  readonly sources: readonly ActionSource[];
  readonly tries: Tries;
  readonly trade: Trade;
  /** Values by hand of the operations with these keys: each takes the place of other ways to do the same. */
  readonly hand: ReadonlyMap<string, HandValues>;
  /** Bound of tries. */
  readonly most: number;
  /** Actions of states, by the stock and what was done. */
  readonly known: Map<string, readonly Action[]>;
}

/** Whether two actions work in the same place. */
export const isInPlace = (a: Action, b: Action): boolean =>
  Math.min(a.place.front, b.place.front) > Math.max(a.place.rear, b.place.rear) &&
  Math.min(a.place.high, b.place.high) > Math.max(a.place.low, b.place.low);

/** Kinds that can take the same material in the same way. */
const FAMILY: Readonly<Partial<Record<Action["kind"], string>>> = {
  roughOutside: "rough",
  roughInside: "rough",
  restRough: "rough",
  recess: "rough",
};

/** Whether two actions are ways to make the same thing. */
export const areRivals = (a: Action, b: Action): boolean =>
  a.key !== b.key &&
  a.site === b.site &&
  (FAMILY[a.kind] ?? a.kind) === (FAMILY[b.kind] ?? b.kind) &&
  (a.threads.length > 0 ? b.threads.some((t) => a.threads.includes(t)) : isInPlace(a, b));

function actionsOf(state: PlanState, { request, sources, hand }: Searching): readonly Action[] {
  const { withoutCycles, withoutTools } = request;
  if (state.done.some(({ action }) => action.kind === "partOff")) return [];
  const all = sources
    .flatMap((source) => source.actions(state, request))
    .filter(
      ({ cycle, tool, threads }) =>
        (cycle === null || !withoutCycles.includes(cycle)) &&
        !withoutTools.includes(tool.T) &&
        (threads.length === 0 || threads.some((t) => !state.threads.has(t))),
    );
  if (hand.size === 0) return all;
  const own = all.map((a) => {
    const set = hand.get(a.key);
    return set ? withHandValues(a, set) : a;
  });
  const here = own.filter((a) => hand.has(a.key));
  return own.filter((a) => here.includes(a) || !here.some((l) => areRivals(l, a)));
}

/** Actions that could be next in a state, those by hand in place of what they replace. */
export function actionsIn(state: PlanState, s: Searching): readonly Action[] {
  const done = state.done.map(({ action }) => action.key).toSorted();
  const question = `${done.join()}\n${s.tries.keyOf(state.stock)}`;
  const known = s.known.get(question) ?? actionsOf(state, s);
  s.known.set(question, known);
  return known;
}

/** Time of a tool change on the machine, s. */
const changeTime = ({ shop: { machine }, rules }: PlanRequest): number => machine?.toolChange ?? rules.toolChange;

/** Time of the tool change before an action, s. */
export const changeBefore = ({ tool }: Action, before: Action | null, request: PlanRequest): number =>
  before?.tool.T === tool.T ? 0 : changeTime(request);

/** The actions that led to a state. */
export const doneIn = ({ done }: PlanState): readonly Action[] => done.map(({ action }) => action);

function withLeft(state: Omit<PlanNode, "left" | "volume" | "open">, { part }: PlanRequest): PlanNode {
  const open = opened(difference(state.stock, part.rings), SLIVER);
  return { ...state, open, left: areaOf(open), volume: turnedVolume(open) };
}

/** The state before the first action. */
export const firstNode = ({ request }: Searching): PlanNode =>
  withLeft(
    { stock: request.blank, done: [], threads: new Set(), before: null, tried: null, cost: 0, seconds: 0 },
    request,
  );

/** The state behind an action that works. */
export function nodeBehind(before: PlanNode, tried: TriedAction, { request, trade }: Searching): PlanNode {
  const { action, stock } = tried;
  const seconds = tried.seconds + changeBefore(action, before.tried?.action ?? null, request);
  return withLeft(
    {
      stock,
      done: [...before.done, tried],
      threads: new Set([...before.threads, ...action.threads]),
      before,
      tried,
      cost: before.cost + seconds + (isCorner(tried) ? 0 : trade.after(action, doneIn(before))),
      seconds: before.seconds + seconds,
    },
    request,
  );
}

/** Smaller cuts do not count in the order of a plan, mm² of the half plane. */
const CORNER = 0.5;

/** Whether a cut is so small that nothing has to wait for it. */
export const isCorner = ({ cut }: { readonly cut: number }): boolean => cut < CORNER;

/** Volume outside the finished part in the place of an action, mm³. */
export const volumeIn = ({ open }: PlanNode, { place: { front, rear, high, low } }: Action): number =>
  turnedVolume(inBox(open, { left: rear, right: front, low, high }));

/** The states of a plan from its beginning, the first one left out. */
export function nodesOf(end: PlanNode): readonly PlanNode[] {
  const nodes: PlanNode[] = [];
  for (let node: PlanNode | null = end; node?.before; node = node.before) nodes.unshift(node);
  return nodes;
}

/** Differences of two ends of a search in the order in which they count; negative: the first is better. */
export function compareEnds(a: PlanNode, b: PlanNode): number {
  const parted = (n: PlanNode) => Number(n.done.some(({ action }) => action.kind === "partOff"));
  const left = a.left - b.left;
  return (
    parted(b) - parted(a) ||
    b.threads.size - a.threads.size ||
    (Math.abs(left) < LEAST_REGION ? 0 : left) ||
    a.cost - b.cost
  );
}
