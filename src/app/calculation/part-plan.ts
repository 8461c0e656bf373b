import { ncLabels } from "../../i18n/nc-labels.ts";
import { planTitles } from "../../i18n/nc/plan-titles.ts";
import type { NcLanguage } from "../../nc/nc-languages.ts";
import type { FinishedPart } from "../../planning/part/finished-part.ts";
import type { PartProblem } from "../../planning/part/part-problem.ts";
import { plannedPart } from "../../planning/part/planned-part.ts";
import { planning } from "../../planning/plan.ts";
import { USUAL_RULES } from "../../planning/shop-rules.ts";
import type { PlanRequest } from "../../planning/types.ts";
import type { PlanChanges, PlanProgress, WorkingPlan } from "../../planning/working-plan.ts";
import { stopwatch } from "../base/clock.ts";
import type { Request } from "./request.ts";

/*
 * Working plans in the worker: the search runs in slices, so that other questions are answered in between and a plan
 * can be stopped.
 */

/** A part to plan. */
export interface PlanOrder {
  readonly part: FinishedPart;
  readonly withoutTools: readonly number[];
  readonly withoutCycles: readonly number[];
  readonly ncLanguage: NcLanguage;
  readonly shop: Pick<Request, "table" | "rapid" | "control" | "machine">;
  readonly changes: PlanChanges;
}

/** A plan, or null with the problems of the part; `stopped`: another order or the operator ended it. */
export type PlanAnswer =
  | { readonly kind: "planned"; readonly plan: WorkingPlan; readonly problems: readonly PartProblem[] }
  | { readonly kind: "noPart"; readonly problems: readonly PartProblem[] }
  | { readonly kind: "stopped" };

/** A slice of the search, and the interval between two reports of its progress, ms. */
const SLICE = 25,
  REPORT = 120;

/** The order in progress; an older one ends at its next slice. */
const orders = { newest: 0 };

const nextTask = () => new Promise<void>((done) => setTimeout(done));

/** What a part is planned from, and the problems of the part; null where these leave none. */
export function planRequestOf(order: Omit<PlanOrder, "changes">): {
  readonly request: PlanRequest | null;
  readonly problems: readonly PartProblem[];
} {
  const { part, blank, clamping, problems } = plannedPart(order.part);
  const { table, rapid, control, machine } = order.shop;
  const request: PlanRequest | null = part && {
    part,
    blank,
    clamping,
    shop: { ...table, rapid, control, ...(machine && { machine }) },
    material: order.part.material,
    rules: { ...USUAL_RULES, ...order.part.rules },
    partsOff: order.part.partsOff,
    withoutCycles: order.withoutCycles,
    withoutTools: order.withoutTools,
    labels: ncLabels(order.ncLanguage),
    titles: planTitles(order.ncLanguage),
  };
  return { request, problems };
}

/** Searches the working plan of a part. `tell` gets the best plan so far. */
export async function planOfPart(order: PlanOrder, tell: (progress: PlanProgress) => void): Promise<PlanAnswer> {
  const { request, problems } = planRequestOf(order);
  if (!request) return { kind: "noPart", problems };
  const mine = ++orders.newest;
  const search = planning(request, order.changes);
  let told = -Infinity;
  for (;;) {
    const begun = stopwatch();
    let next = search.next();
    while (!next.done && stopwatch() - begun < SLICE) next = search.next();
    if (next.done) return { kind: "planned", plan: next.value, problems };
    if (begun - told > REPORT) {
      told = begun;
      tell(next.value);
    }
    await nextTask();
    if (mine !== orders.newest) return { kind: "stopped" };
  }
}

/** Stops the search in progress. */
export function stopPlanning(): void {
  orders.newest += 1;
}
