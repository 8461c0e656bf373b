import { areaOf } from "../kernel/area/area.ts";
import { boxAround, inBox } from "../kernel/area/box.ts";
import { difference, opened } from "../kernel/area/clip.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import { threadId, threadsOf } from "./actions/thread.ts";
import { LEAST_REGION } from "./open-regions.ts";
import { allActionsIn, areRivals, changeBefore, doneIn, nodesOf, type PlanNode, type Searching } from "./plan-node.ts";
import { isInPlace } from "./places.ts";
import type { Action, PlanRequest, TriedAction } from "./types.ts";
import type { OtherWay, PlanStep, StepReason } from "./working-plan.ts";

/** Most other ways that a step shows. */
const MOST_OTHERS = 2;
/** Shorter differences are none: s, and part of the time of the step. */
const NO_TIME = 0.5;
const NO_SHARE = 0.01;
/** Part of the material of a step that another way has to take, too. */
const SHARED = 0.5;

/** Other ways that were open for a step. */
const rivalsOf = ({ action }: TriedAction, state: PlanNode, s: Searching): readonly Action[] =>
  allActionsIn(state, s).filter((a) => areRivals(a, action));

/** A rival as another way; null where it does not work or works elsewhere. */
function wayOf(rival: TriedAction, chosen: TriedAction, state: PlanNode, { request }: Searching): OtherWay | null {
  if (!rival.works) return null;
  const taken = difference(state.stock, chosen.stock);
  const leaves = areaOf(difference(rival.stock, chosen.stock)) - areaOf(difference(chosen.stock, rival.stock));
  const shared = areaOf(taken) - areaOf(difference(rival.stock, chosen.stock));
  if (chosen.action.threads.length === 0 && shared < SHARED * areaOf(taken)) return null;
  const before = state.tried?.action ?? null;
  const seconds = rival.seconds + changeBefore(rival.action, before, request);
  const longer = seconds - chosen.seconds - changeBefore(chosen.action, before, request);
  return { tried: rival, seconds, longer, leaves };
}

/** Most tries that look for another tool, or another cycle, before a step says that there is none. */
const MOST_CLAIMED = 8;

/**
 * A way with another tool or another cycle that no source proposed beside the better ones; null where none works, and
 * undefined where not all were tried. Yields before every try.
 */
function* hiddenWay(
  chosen: TriedAction,
  state: PlanNode,
  by: "tool" | "cycle",
  s: Searching,
): Generator<PlanNode, OtherWay | null | undefined> {
  const valueOf = ({ tool, cycle }: Action) => (by === "tool" ? tool.T : cycle);
  const tried = new Set([valueOf(chosen.action)]);
  for (let count = 0; ;) {
    const without = [...tried].flatMap((n) => n ?? []);
    const { withoutTools, withoutCycles } = s.request;
    const request: PlanRequest = {
      ...s.request,
      ...(by === "tool"
        ? { withoutTools: [...withoutTools, ...without] }
        : { withoutCycles: [...withoutCycles, ...without] }),
    };
    const rivals = s.sources
      .flatMap((source) => source.actions(state, request))
      .filter((a) => areRivals(a, chosen.action) && !tried.has(valueOf(a)));
    if (rivals.length === 0) return null;
    for (const rival of rivals) {
      if ((count += 1) > MOST_CLAIMED) return undefined;
      yield state;
      const way = wayOf(s.tries.of(rival, state), chosen, state, s);
      if (way) return way;
      tried.add(valueOf(rival));
    }
  }
}

/** Ways that leave no more than others come first, then the quicker ones. */
const compareWays = (a: OtherWay, b: OtherWay): number =>
  (Math.abs(a.leaves - b.leaves) < LEAST_REGION ? 0 : a.leaves - b.leaves) || a.longer - b.longer;

/** What is the same in a step and all its other ways, tried: its tool, else its cycle; null where neither is. */
type Sole = "tool" | "cycle" | null;

function reasonsOf(
  node: PlanNode,
  ways: readonly OtherWay[],
  { sole: same, isByHand }: { readonly sole: Sole; readonly isByHand: boolean },
  s: Searching,
): readonly StepReason[] {
  const { tried, before } = node;
  if (!tried || !before) return [];
  const { action } = tried;
  const last = before.tried?.action ?? null;
  const done = doneIn(before);
  const [next] = ways;
  const rule = last && s.trade.between(last, action);
  const rest = done.findLastIndex((d) => d.site === action.site && isInPlace(d, action));
  const sole: readonly StepReason[] = [
    ...(same === "tool" ? [{ kind: "onlyTool" as const, tool: action.tool.T }] : []),
    ...(same === "cycle" ? [{ kind: "onlyCycle" as const, cycle: action.cycle }] : []),
  ];
  const way = [...sole, ...(next ? [comparedWith(next, tried, s)] : [])].flatMap((r) => r ?? []);
  return [
    ...(isByHand ? [{ kind: "byHand" as const }] : []),
    ...way,
    ...(action.reamer === undefined ? [] : [{ kind: "undersize" as const, tool: action.reamer }]),
    ...(action.inOneCall ? [{ kind: "inOneCall" as const }] : []),
    ...(last?.tool.T === action.tool.T ? [{ kind: "sameTool" as const, tool: action.tool.T }] : []),
    ...(action.kind === "restRough" && rest >= 0 ? [{ kind: "rest" as const, step: rest }] : []),
    ...(rule ? [{ kind: "rule" as const, rule }] : []),
    ...(action.kind === "partOff" ? unfinished(before, s) : []),
  ];
}

/** What parting off leaves undone: no tool could make it before. */
function unfinished({ open, threads }: PlanNode, { request: { part } }: Searching): readonly StepReason[] {
  const { left, right, high } = boxAround(part.rings);
  const area = areaOf(opened(inBox(open, { left: left + SLIVER, right, low: 0, high }), SLIVER));
  const missed = [part.outside, part.inside].flatMap((chain) =>
    threadsOf(chain).flatMap((place) => (threads.has(threadId(chain, place)) ? [] : [place.designation])),
  );
  return area < LEAST_REGION && missed.length === 0
    ? []
    : [{ kind: "unfinished", area: area < LEAST_REGION ? 0 : area, threads: missed }];
}

/** What speaks for a step beside the next way; null where nothing does. */
function comparedWith(
  { tried: { action }, longer, leaves }: OtherWay,
  { action: chosen, seconds }: TriedAction,
  { request: { usualTools = [] } }: Searching,
): StepReason | null {
  const other = { cycle: action.cycle, tool: action.tool.T };
  if (leaves >= LEAST_REGION) return { kind: "takesMore", area: leaves, ...other };
  if (longer < NO_TIME && usualTools.includes(action.tool.T) && !usualTools.includes(chosen.tool.T))
    return { kind: "ownTool", ...other };
  const isLonger = Math.abs(longer) > Math.max(NO_TIME, NO_SHARE * seconds);
  if (!isLonger) return { kind: "equal", ...other };
  return longer > 0 ? { kind: "faster", seconds: longer, ...other } : null;
}

/** The steps of a plan with their reasons. Yields before every try. */
export function* explained(
  end: PlanNode,
  byHand: ReadonlySet<string>,
  s: Searching,
): Generator<PlanNode, readonly PlanStep[]> {
  const steps: PlanStep[] = [];
  for (const node of nodesOf(end)) {
    const { tried, before: state } = node;
    if (!tried || !state) continue;
    const ways: OtherWay[] = [];
    for (const rival of rivalsOf(tried, state, s)) {
      yield end;
      const way = wayOf(s.tries.of(rival, state), tried, state, s);
      if (way) ways.push(way);
    }
    let sole: Sole = null;
    for (const by of ["tool", "cycle"] as const) {
      const valueOf = ({ action: { tool, cycle } }: TriedAction) => (by === "tool" ? tool.T : cycle);
      if (sole !== null || ways.some((w) => valueOf(w.tried) !== valueOf(tried))) continue;
      const way = yield* hiddenWay(tried, state, by, s);
      if (way) ways.push(way);
      else if (way === null) sole = by;
    }
    ways.sort(compareWays);
    const seconds = node.seconds - state.seconds;
    const isByHand = byHand.has(tried.action.key);
    steps.push({
      tried,
      seconds,
      penalty: node.cost - state.cost - seconds,
      why: reasonsOf(node, ways, { sole, isByHand }, s),
      others: ways.slice(0, MOST_OTHERS),
      isByHand,
    });
  }
  return steps;
}
