import { difference, offset, opened } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import { diameter, perSide } from "../kernel/units.ts";
import { withHandValues } from "./hand-values.ts";
import { LEAST_REGION, workIn } from "./open-regions.ts";
import { perObject } from "../nc/per-object.ts";
import { isInPlace } from "./places.ts";
import { ofPieces, turnedVolume } from "./stock-key.ts";
import type { Trade } from "./trade-rules.ts";
import type { Tries } from "./tries.ts";
import type { Action, ActionKind, ActionSource, HandValues, PlanRequest, PlanState, TriedAction } from "./types.ts";

/** A state of the search with the way to it. */
export interface PlanNode extends PlanState {
  readonly before: PlanNode | null;
  /** The step that led here; null at the beginning. */
  readonly tried: TriedAction | null;
  /** Cost so far, s: time, tool changes, rules; and the time alone. */
  readonly cost: number;
  readonly seconds: number;
  /** Pieces of material outside the finished part that are work, mm² of the half plane; all such material, mm³. */
  readonly left: number;
  readonly volume: number;
  /** The share of the volume within the oversize for finishing, mm³. */
  readonly skin: number;
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
  readonly ends: Ends;
  /** Operations that are not proposed, by their key: the whole program of a plan showed that they are at fault. */
  readonly without: ReadonlySet<string>;
  /** What the sources propose in states, by the stock and what was done. */
  readonly known: Map<string, readonly Action[]>;
}

/** Kinds that can take the same material in the same way. */
const FAMILY: Readonly<Partial<Record<Action["kind"], string>>> = {
  roughOutside: "rough",
  roughInside: "rough",
  restRough: "rough",
  recess: "rough",
  ream: "finishInside",
};

/** Whether two actions are ways to make the same thing. */
export const areRivals = (a: Action, b: Action): boolean =>
  a.key !== b.key &&
  a.site === b.site &&
  (FAMILY[a.kind] ?? a.kind) === (FAMILY[b.kind] ?? b.kind) &&
  (a.threads.length > 0 ? b.threads.some((t) => a.threads.includes(t)) : isInPlace(a, b));

/**
 * What a source proposes in a state and is neither excluded nor done, with the values set by hand. Of what was done it
 * sees its own kind and what finishes besides roughing: other ways to the same stock need no other answer.
 */
function proposedBy(source: ActionSource, state: PlanState, s: Searching): readonly Action[] {
  const { request, hand } = s;
  const own = state.done.filter(({ action }) => action.kind === source.kind || action.inOneCall);
  const done = own.map(({ action }) => action.key).toSorted();
  const question = `${s.sources.indexOf(source)} ${s.tries.keyOf(state.stock)} ${done.join()}`;
  const known = s.known.get(question);
  if (known) return known;
  const made = source
    .actions({ ...state, done: own }, request)
    .filter(
      ({ cycle, key, tool, threads }) =>
        !s.without.has(key) &&
        (cycle === null || !request.withoutCycles.includes(cycle)) &&
        !request.withoutTools.includes(tool.T) &&
        (threads.length === 0 || threads.some((t) => !state.threads.has(t))),
    )
    .map((action) => {
      const set = hand.get(action.key);
      return set ? withHandValues(action, set) : action;
    });
  s.known.set(question, made);
  return made;
}

/**
 * Actions that could be next in a state, those by hand in place of what they replace. `kind`: at least those of one
 * kind. Without those that rough and finish in one call: whether one tool does both is known at the end of a search.
 */
export const actionsIn = (state: PlanState, s: Searching, kind?: ActionKind): readonly Action[] =>
  s.hand.size === 0
    ? openIn(state, s, (source) => !source.inOneCall && source.kind === (kind ?? source.kind))
    : allActionsIn(state, s).filter((a) => !a.inOneCall || s.hand.has(a.key));

/** The same with all of them. */
export const allActionsIn = (state: PlanState, s: Searching, kind?: ActionKind): readonly Action[] =>
  openIn(state, s, (source) => s.hand.size > 0 || source.kind === (kind ?? source.kind));

function openIn(state: PlanState, s: Searching, asks: (source: ActionSource) => boolean): readonly Action[] {
  if (state.done.some(({ action }) => action.kind === "partOff")) return [];
  const { sources, hand } = s;
  const all = sources.filter(asks).flatMap((source) => proposedBy(source, state, s));
  const here = all.filter((a) => hand.has(a.key));
  return here.length === 0 ? all : all.filter((a) => here.includes(a) || !here.some((l) => areRivals(l, a)));
}

/** Time of a tool change on the machine, s. */
const changeTime = ({ shop: { machine }, rules }: PlanRequest): number => machine?.toolChange ?? rules.toolChange;

/** Time of the tool change before an action, s. */
export const changeBefore = ({ tool }: Action, before: Action | null, request: PlanRequest): number =>
  before?.tool.T === tool.T ? 0 : changeTime(request);

/** Price of the tool of an action that the operator's table lacks, where no action before has it, s. */
export const priceOf = ({ tool }: Action, done: readonly Action[], { rules, usualTools = [] }: PlanRequest): number =>
  usualTools.includes(tool.T) && done.every((d) => d.tool.T !== tool.T) ? rules.usualTool : 0;

/** The actions that led to a state. */
export const doneIn = ({ done }: PlanState): readonly Action[] => done.map(({ action }) => action);

/** What of a stock is outside the finished part. */
type Left = Pick<PlanNode, "left" | "volume" | "skin" | "open">;

/** Many orders of the same steps end at one stock: what is left does not depend on the way to it. */
const leftOf = perObject((request: PlanRequest) => {
  const { part, rules } = request;
  const grown = offset(part.rings, Math.max(perSide(diameter(rules.allowance.diameter)), rules.allowance.z));
  return perObject((stock: readonly Ring[]): Left => {
    const all = difference(stock, part.rings);
    const open = ofPieces(all, 0, "open", (piece) => opened(piece, SLIVER), request);
    const volume = turnedVolume(open);
    const skin = volume - turnedVolume(difference(open, grown));
    return { open, left: workIn(open), volume, skin };
  });
});

const withLeft = (state: Omit<PlanNode, keyof Left>, request: PlanRequest): PlanNode => ({
  ...state,
  ...leftOf(request)(state.stock),
});

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
  const done = doneIn(before);
  return withLeft(
    {
      stock,
      done: [...before.done, tried],
      threads: new Set([...before.threads, ...action.threads]),
      before,
      tried,
      cost:
        before.cost +
        seconds +
        trade.wear(action, tried.seconds) +
        priceOf(action, done, request) +
        (isCorner(tried) ? 0 : trade.after(action, done)),
      seconds: before.seconds + seconds,
    },
    request,
  );
}

/** Smaller cuts do not count in the order of a plan, mm² of the half plane. */
const CORNER = 0.5;

/** Whether a cut is so small that nothing has to wait for it. */
export const isCorner = ({ cut }: { readonly cut: number }): boolean => cut < CORNER;

/** The states of a plan from its beginning, the first one left out. */
export function nodesOf(end: PlanNode): readonly PlanNode[] {
  const nodes: PlanNode[] = [];
  for (let node: PlanNode | null = end; node?.before; node = node.before) nodes.unshift(node);
  return nodes;
}

/** Whether the part is off its bar. */
export const isParted = ({ done }: PlanNode): boolean => done.some(({ action }) => action.kind === "partOff");

/**
 * Differences of two states in the order in which they count; negative: the first is better. `least`: what leaves less
 * than a region more than this leaves as much, mm².
 */
export function compareStates(a: PlanNode, b: PlanNode, least = Math.min(a.left, b.left)): number {
  const over = ({ left }: PlanNode) => (left < least + LEAST_REGION ? 0 : left - least);
  return (
    Number(isParted(b)) - Number(isParted(a)) || b.threads.size - a.threads.size || over(a) - over(b) || a.cost - b.cost
  );
}

/**
 * The ends of one search. How much is left is compared with the least of them all: compared in pairs, each could leave a
 * little more than the one before it until the last leaves much more than the first.
 */
export class Ends {
  private readonly least = new Map<string, number>();

  /** Whether the first of two ends is better. */
  isBetter(a: PlanNode, b: PlanNode): boolean {
    const made = (n: PlanNode) => `${isParted(n)} ${n.threads.size}`;
    for (const n of [a, b]) this.least.set(made(n), Math.min(n.left, this.least.get(made(n)) ?? Infinity));
    return compareStates(a, b, this.least.get(made(a))) < 0;
  }
}
