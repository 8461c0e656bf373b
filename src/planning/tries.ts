import { applyAction } from "./apply-action.ts";
import { localKey, stockKey, turnedVolume } from "./stock-key.ts";
import { ROUGHING, type Action, type PlanRequest, type PlanState, type TriedAction } from "./types.ts";

/** Whether an action takes the oversize that roughing leaves. */
export const finishes = ({ kind }: Pick<Action, "kind">): boolean => !ROUGHING.has(kind) && kind !== "partOff";

/** What an action did where the stock in its place was the same. */
export interface Expected {
  readonly works: boolean;
  readonly seconds: number;
  /** Material that it takes: mm² of the half plane, and mm³. */
  readonly cut: number;
  readonly volume: number;
}

/** Everything that was tried in one search. */
export class Tries {
  /** Simulated actions. */
  count = 0;
  /** Most material that any action took in a second, mm³/s. */
  rate = 0;
  /** The same of finishing cuts. */
  private finishingRate = 0;
  private readonly results = new Map<string, TriedAction>();
  private readonly expected = new Map<string, Expected>();
  private readonly names = new WeakMap<Action, string>();
  private readonly places = new WeakMap<PlanState["stock"], WeakMap<Action, string>>();
  private readonly stocks = new WeakMap<PlanState["stock"], string>();

  constructor(private readonly request: PlanRequest) {}

  /** The result of an action on the stock of a state. */
  of(action: Action, { stock }: Pick<PlanState, "stock">): TriedAction {
    const question = `${this.nameOf(action)}\n${this.keyOf(stock)}`;
    const known = this.results.get(question);
    if (known) return known.action === action ? known : { ...known, action };
    this.count += 1;
    const tried = applyAction(action, { stock }, this.request);
    const { works, seconds, cut } = tried;
    const volume = works ? turnedVolume(stock) - turnedVolume(tried.stock) : 0;
    this.results.set(question, tried);
    this.expected.set(this.placeOf(action, stock), { works, seconds, cut, volume });
    // Parting off takes the rest of the bar at once.
    if (works && seconds > 0 && action.kind !== "partOff") {
      this.rate = Math.max(this.rate, volume / seconds);
      if (finishes(action)) this.finishingRate = Math.max(this.finishingRate, volume / seconds);
    }
    return tried;
  }

  /** What an action does to a stock as far as that is known without a try; null where it is not. */
  expectedOf(action: Action, { stock }: Pick<PlanState, "stock">): Expected | null {
    return this.expected.get(this.placeOf(action, stock)) ?? null;
  }

  /** Least time for a volume, s; `isSkin`: of what only finishing takes. */
  leastFor(volume: number, isSkin = false): number {
    const rate = (isSkin && this.finishingRate) || this.rate;
    return rate > 0 ? Math.max(0, volume) / rate : 0;
  }

  /** A stock as a text. */
  keyOf(stock: PlanState["stock"]): string {
    const key = this.stocks.get(stock) ?? stockKey(stock);
    this.stocks.set(stock, key);
    return key;
  }

  /** An action with all its values as a text. The blank of its job only says how far it keeps away. */
  private nameOf(action: Action): string {
    const known = this.names.get(action);
    if (known !== undefined) return known;
    const { drafts, cycle, start, contour, spindle, tool } = action.job;
    const name = JSON.stringify([action.key, drafts[cycle], start, contour, spindle, tool, action.cut]);
    this.names.set(action, name);
    return name;
  }

  private placeOf(action: Action, stock: PlanState["stock"]): string {
    const inStock = this.places.get(stock) ?? new WeakMap<Action, string>();
    this.places.set(stock, inStock);
    const place = inStock.get(action) ?? `${this.nameOf(action)}\n${localKey(stock, action)}`;
    inStock.set(action, place);
    return place;
  }
}
