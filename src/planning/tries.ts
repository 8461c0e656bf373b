import { applyAction } from "./apply-action.ts";
import { localKey, stockKey, turnedVolume } from "./stock-key.ts";
import type { Action, PlanRequest, PlanState, TriedAction } from "./types.ts";

/** What is known of an action before it is tried on a stock. */
export interface Expected {
  readonly seconds: number;
  /** mm³ of material that it takes. */
  readonly volume: number;
  readonly works: boolean;
}

/** Everything that was tried in one search. */
export class Tries {
  /** Simulated actions. */
  count = 0;
  /** Most material that any action took in a second, mm³/s. */
  rate = 0;
  private readonly results = new Map<string, TriedAction>();
  private readonly expected = new Map<string, Expected>();
  private readonly names = new WeakMap<Action, string>();
  private readonly stocks = new WeakMap<PlanState["stock"], string>();

  constructor(private readonly request: PlanRequest) {}

  /** The result of an action on the stock of a state. */
  of(action: Action, state: Pick<PlanState, "stock">): TriedAction {
    const question = `${this.nameOf(action)}\n${this.keyOf(state.stock)}`;
    const known = this.results.get(question);
    if (known) return known.action === action ? known : { ...known, action };
    this.count += 1;
    const tried = applyAction(action, state, this.request);
    const volume = tried.works ? turnedVolume(state.stock) - turnedVolume(tried.stock) : 0;
    this.results.set(question, tried);
    this.expected.set(this.placeOf(action, state.stock), { seconds: tried.seconds, volume, works: tried.works });
    if (tried.works && tried.seconds > 0) this.rate = Math.max(this.rate, volume / tried.seconds);
    return tried;
  }

  /** What the action did where the stock in its place was the same; null where it was not tried there. */
  expectedOf(action: Action, { stock }: Pick<PlanState, "stock">): Expected | null {
    return this.expected.get(this.placeOf(action, stock)) ?? null;
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
    return `${this.nameOf(action)}\n${localKey(stock, action)}`;
  }
}
