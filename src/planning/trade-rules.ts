import type { Action, ActionKind, PlanRequest, ShopRules } from "./types.ts";
import { FINISHING, type TradeRule } from "./working-plan.ts";

/** One rule of the trade: doing something of `first` after something of `then` costs time that a shop can set. */
export interface Rule {
  readonly rule: TradeRule;
  readonly first: (action: Action, request: PlanRequest) => boolean;
  readonly then: (action: Action, request: PlanRequest) => boolean;
  readonly cost: (rules: ShopRules) => number;
}

const isOf =
  (...kinds: readonly ActionKind[]) =>
  ({ kind }: Action) =>
    kinds.includes(kind);

const ROUGHING = ["roughOutside", "roughInside", "restRough"] as const;
const BORING = ["centre", "drill"] as const;

const finishes = ({ kind }: Action) => FINISHING.has(kind);

/** Whether an action finishes an element with a tolerance. */
function isToleranced(action: Action, { part }: PlanRequest): boolean {
  if (!finishes(action)) return false;
  const { segments, marks } = action.site === "inside" ? part.inside : part.outside;
  const { front, rear } = action.place;
  return segments.some(
    ({ from, to }, i) => marks[i]?.tolerance !== undefined && (from.z + to.z) / 2 < front && (from.z + to.z) / 2 > rear,
  );
}

/** A price that no time of cutting outweighs, s. */
const NEVER = 100_000;

/** Rules of the trade. "One tool as long as it can" needs none: a tool change costs its time. */
export const TRADE_RULES: readonly Rule[] = [
  { rule: "faceFirst", first: isOf("face"), then: ({ kind }) => kind !== "face", cost: (r) => r.finishBeforeRough },
  {
    rule: "roughBeforeFinish",
    first: isOf(...ROUGHING, ...BORING),
    then: finishes,
    cost: (r) => r.finishBeforeRough,
  },
  {
    rule: "longBeforeThin",
    first: isOf("roughOutside", "restRough"),
    then: isOf("recess", "undercut"),
    cost: (r) => r.thinBeforeLong,
  },
  {
    rule: "outsideBeforeInside",
    first: isOf("roughOutside"),
    then: isOf("roughInside"),
    cost: (r) => r.insideBeforeOutside,
  },
  {
    rule: "outsideBeforeInside",
    first: isOf("finishOutside"),
    then: isOf("finishInside"),
    cost: (r) => r.insideBeforeOutside,
  },
  { rule: "centreFirst", first: isOf("centre"), then: isOf("drill"), cost: (r) => r.finishBeforeRough },
  {
    rule: "undercutBeforeThread",
    first: isOf("recess", "undercut", "finishOutside", "finishInside"),
    then: isOf("thread"),
    cost: (r) => r.finishBeforeRough,
  },
  {
    rule: "tolerancedLast",
    first: (action, request) =>
      isOf("finishOutside", "finishInside", "recess", "undercut")(action) && !isToleranced(action, request),
    then: isToleranced,
    cost: (r) => r.thinBeforeLong,
  },
  { rule: "partOffLast", first: ({ kind }) => kind !== "partOff", then: isOf("partOff"), cost: () => NEVER },
];

/** What it costs to do an action after others, s. */
export const penaltyAfter = (action: Action, done: readonly Action[], request: PlanRequest): number =>
  TRADE_RULES.reduce(
    (sum, { first, then, cost }) =>
      first(action, request) && done.some((d) => then(d, request)) ? sum + cost(request.rules) : sum,
    0,
  );

/** What it will cost to do an action while others are still to be done, s: the price of the costliest rule. */
export const penaltyBefore = (action: Action, waiting: readonly Action[], request: PlanRequest): number =>
  TRADE_RULES.reduce(
    (sum, { first, then, cost }) =>
      then(action, request) && waiting.some((w) => w.key !== action.key && first(w, request))
        ? sum + cost(request.rules)
        : sum,
    0,
  );

/** The first rule that puts an action behind those that are done. */
export const ruleBehind = (action: Action, done: readonly Action[], request: PlanRequest): TradeRule | null =>
  TRADE_RULES.find(({ first, then }) => then(action, request) && done.some((d) => first(d, request)))?.rule ?? null;
