import { boxAround } from "../kernel/area/box.ts";
import { SAME } from "../kernel/tolerance.ts";
import { isInPlace, isSameWork } from "./places.ts";
import { FINISHING, type Action, type ActionKind, type PlanRequest, type ShopRules } from "./types.ts";
import type { TradeRule } from "./working-plan.ts";

/** One rule of the trade: doing something of `first` after something of `then` costs time that a shop can set. */
interface Rule {
  /** Null: it goes without saying. */
  readonly rule: TradeRule | null;
  readonly first: (action: Action, request: PlanRequest) => boolean;
  readonly then: (action: Action, request: PlanRequest) => boolean;
  /** Pairs that the rule does not order: one needs the other, or they are apart. */
  readonly except?: (first: Action, then: Action, request: PlanRequest) => boolean;
  /** s. */
  readonly cost: (rules: ShopRules) => number;
}

const isOf =
  (...kinds: readonly ActionKind[]) =>
  ({ kind }: Action) =>
    kinds.includes(kind);

const CHIPS = ["roughOutside", "roughInside", "restRough"] as const;
const finishes = ({ kind, inOneCall }: Action) => inOneCall ?? FINISHING.has(kind);

/** Whether an action finishes an element with a tolerance. */
function isToleranced(action: Action, { part }: PlanRequest): boolean {
  if (!finishes(action)) return false;
  const { segments, marks } = action.site === "inside" ? part.inside : part.outside;
  const { front, rear } = action.place;
  return segments.some(
    ({ from, to }, i) => marks[i]?.tolerance !== undefined && (from.z + to.z) / 2 < front && (from.z + to.z) / 2 > rear,
  );
}

/** Whether an action is a groove behind the rear face of a part that is parted off there. */
const isAtParting = ({ kind, place }: Action, { part: { rings }, partsOff }: PlanRequest): boolean =>
  kind === "recess" && partsOff && place.rear < boxAround(rings).left - SAME;

/** A price that no time of cutting outweighs, s. */
const NEVER = 100_000;

/** Rules of the trade. "One tool as long as it can" needs none: a tool change costs its time. */
const TRADE_RULES: readonly Rule[] = [
  { rule: "faceFirst", first: isOf("face"), then: ({ kind }) => kind !== "face", cost: (r) => r.finishBeforeRough },
  {
    rule: "roughBeforeFinish",
    first: isOf(...CHIPS, "centre", "drill"),
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
    then: isOf("finishInside", "ream"),
    cost: (r) => r.insideBeforeOutside,
  },
  { rule: null, first: isOf("centre"), then: isOf("drill"), cost: (r) => r.finishBeforeRough },
  {
    rule: "undercutBeforeThread",
    first: isOf("recess", "undercut", "finishOutside", "finishInside", "ream"),
    then: isOf("thread"),
    except: (first, then) => first.site !== then.site,
    cost: (r) => r.finishBeforeRough,
  },
  {
    rule: "tolerancedLast",
    first: (action, request) =>
      isOf("finishOutside", "finishInside", "ream", "recess", "undercut", "thread")(action) &&
      !isToleranced(action, request),
    then: isToleranced,
    // The crest of a thread is finished with the surfaces beside it; a groove behind the part weakens what holds it.
    except: (first, then, request) =>
      (first.kind === "thread" && first.site === then.site && isInPlace(first, then)) || isAtParting(first, request),
    cost: (r) => r.tolerancedLast,
  },
  { rule: null, first: ({ kind }) => kind !== "partOff", then: isOf("partOff"), cost: () => NEVER },
];

/** What a second of roughing with a finishing insert costs besides, s: its nose wears in place of a strong one. */
const PER_WEAK_SECOND = 1;
const isWeak = (action: Action): boolean => isOf(...CHIPS)(action) && action.tool.TYPE === "FINISH";

/** The sides of the rules on which an action stands, as bits in the order of the rules. */
interface Sides {
  readonly first: number;
  readonly then: number;
}

/** The rules of the trade for one request. */
export class Trade {
  private readonly known = new WeakMap<Action, Sides>();

  constructor(private readonly request: PlanRequest) {}

  /** What a cut of a length costs besides its time, s: roughing is for strong inserts. */
  wear(action: Action, seconds: number): number {
    return isWeak(action) ? PER_WEAK_SECOND * seconds : 0;
  }

  /** What it costs to do an action after others, s. */
  after(action: Action, done: readonly Action[]): number {
    return this.cost(done.reduce((bits, d) => bits | this.broken(action, d), 0));
  }

  /** What doing an action makes others cost that are still to be done, s. Those that do the same do not wait for it. */
  before(action: Action, waiting: readonly Action[]): number {
    return this.cost(waiting.reduce((bits, w) => (isSameWork(w, action) ? bits : bits | this.broken(w, action)), 0));
  }

  /** The rule that puts an action behind the action before it; null where none does. */
  between(before: Action, action: Action): TradeRule | null {
    const bits = this.broken(before, action);
    return TRADE_RULES.find((_, i) => (bits & (1 << i)) !== 0)?.rule ?? null;
  }

  /** The rules that are broken where the first of two actions comes second, as bits. */
  private broken(first: Action, then: Action): number {
    const bits = this.sides(first).first & this.sides(then).then;
    return bits === 0
      ? 0
      : TRADE_RULES.reduce(
          (all, { except }, i) => (bits & (1 << i) && except?.(first, then, this.request) ? all & ~(1 << i) : all),
          bits,
        );
  }

  private cost(bits: number): number {
    return bits === 0
      ? 0
      : TRADE_RULES.reduce((sum, { cost }, i) => (bits & (1 << i) ? sum + cost(this.request.rules) : sum), 0);
  }

  private sides(action: Action): Sides {
    const known = this.known.get(action);
    if (known) return known;
    const bits = (side: "first" | "then") =>
      TRADE_RULES.reduce((all, rule, i) => (rule[side](action, this.request) ? all | (1 << i) : all), 0);
    const made = { first: bits("first"), then: bits("then") };
    this.known.set(action, made);
    return made;
  }
}
