import { difference } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { applyAction } from "./apply-action.ts";
import { localKey, stockKey, turnedVolume } from "./stock-key.ts";
import { boundOf, type Bound } from "./bound.ts";
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

/** A try with the material that it took. */
interface Known extends Expected {
  readonly tried: TriedAction;
  /** Null until it is asked for. */
  taken: readonly Ring[] | null;
  readonly before: readonly Ring[];
}

/**
 * Everything that was tried in one search. Where the stock in the place of an action is the same it takes the same:
 * such a try is not simulated again.
 */
export class Tries {
  /** Simulated actions. */
  count: number;
  /** Most material that any action took in a second, mm³/s. */
  rate = 0;
  /** The same of finishing cuts. */
  private finishingRate = 0;
  private readonly results = new Map<string, TriedAction>();
  private readonly known = new Map<string, Known>();
  private readonly bounds = new Map<string, Bound>();
  /** Short names of long texts, and of what the texts are made from. */
  private readonly short = new Map<string, string>();
  private readonly names = new WeakMap<Action, string>();
  private readonly places = new WeakMap<PlanState["stock"], WeakMap<Action, string>>();
  private readonly stocks = new WeakMap<PlanState["stock"], string>();

  /** `former`: tries of a search that is made again, now each on its whole stock. */
  constructor(
    private readonly request: PlanRequest,
    private readonly former: Tries | null = null,
  ) {
    this.count = former?.count ?? 0;
  }

  /** The result of an action on the stock of a state. */
  of(action: Action, { stock }: Pick<PlanState, "stock">): TriedAction {
    const question = `${this.nameOf(action)} ${this.keyOf(stock)}`;
    const known = this.results.get(question);
    if (known) return known.action === action ? known : { ...known, action };
    const place = this.placeOf(action, stock);
    const before = this.known.get(place);
    // After parting off the stock is the part: nothing is taken from a place.
    const isKnown = before && !this.former && action.kind !== "partOff";
    const tried = isKnown ? { ...before.tried, action, stock: lessCut(stock, before) } : this.simulated(action, stock);
    this.results.set(question, tried);
    if (before && isKnown) return tried;
    const { works, seconds, cut } = tried;
    const volume = works ? turnedVolume(stock) - turnedVolume(tried.stock) : 0;
    this.known.set(place, { works, seconds, cut, volume, tried, taken: null, before: stock });
    // Parting off takes the rest of the bar at once.
    if (works && seconds > 0 && action.kind !== "partOff") {
      this.rate = Math.max(this.rate, volume / seconds);
      if (finishes(action)) this.finishingRate = Math.max(this.finishingRate, volume / seconds);
    }
    return tried;
  }

  private simulated(action: Action, stock: PlanState["stock"]): TriedAction {
    this.count += 1;
    return applyAction(action, { stock }, this.request);
  }

  /** What an action does to a stock as far as that is known without a try; null where it is not. */
  expectedOf(action: Action, { stock }: Pick<PlanState, "stock">): Expected | null {
    return this.known.get(this.placeOf(action, stock)) ?? null;
  }

  /** The best that an action can do in a state. */
  boundOf(action: Action, { stock, open }: Pick<PlanState, "stock"> & { readonly open: readonly Ring[] }): Bound {
    const place = this.placeOf(action, stock);
    const bound = this.bounds.get(place) ?? boundOf(action, open, this.request);
    this.bounds.set(place, bound);
    return bound;
  }

  /** Least time for a volume, s; `isSkin`: of what only finishing takes. */
  leastFor(volume: number, isSkin = false): number {
    const rate = (isSkin && this.finishingRate) || this.rate;
    return rate > 0 ? Math.max(0, volume) / rate : 0;
  }

  /** The same name for the same stock. */
  keyOf(stock: PlanState["stock"]): string {
    const key = this.stocks.get(stock) ?? this.shortOf(stockKey(stock));
    this.stocks.set(stock, key);
    return key;
  }

  private shortOf(text: string): string {
    const name = this.short.get(text) ?? String(this.short.size);
    this.short.set(text, name);
    return name;
  }

  /** A name of an action with all its values. The blank of its job only says how far it keeps away. */
  private nameOf(action: Action): string {
    const known = this.names.get(action);
    if (known !== undefined) return known;
    const { drafts, cycle, start, contour, spindle, tool } = action.job;
    const name = this.shortOf(JSON.stringify([action.key, drafts[cycle], start, contour, spindle, tool, action.cut]));
    this.names.set(action, name);
    return name;
  }

  private placeOf(action: Action, stock: PlanState["stock"]): string {
    const inStock = this.places.get(stock) ?? new WeakMap<Action, string>();
    this.places.set(stock, inStock);
    const place = inStock.get(action) ?? `${this.nameOf(action)} ${this.shortOf(localKey(stock, action))}`;
    inStock.set(action, place);
    return place;
  }
}

/** A stock without what a try took from another one. */
function lessCut(stock: readonly Ring[], of: Known): readonly Ring[] {
  of.taken ??= difference(of.before, of.tried.stock);
  return of.taken.length === 0 ? stock : difference(stock, of.taken);
}
