import type { Ring } from "../../kernel/geometry/point.ts";
import type { AnyIssue } from "../../i18n/message-texts.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { planTitles } from "../../i18n/nc/plan-titles.ts";
import type { NcLanguage } from "../../nc/nc-languages.ts";
import type { FinishedPart } from "../../planning/part/finished-part.ts";
import type { PartProblem } from "../../planning/part/part-problem.ts";
import { plannedPart } from "../../planning/part/planned-part.ts";
import { planning } from "../../planning/plan.ts";
import { applyAction, runAction } from "../../planning/apply-action.ts";
import { withHandValues } from "../../planning/hand-values.ts";
import { USUAL_RULES } from "../../planning/shop-rules.ts";
import type { Action, HandValues, PlanRequest, TriedAction } from "../../planning/types.ts";
import type { PlanChanges, PlanProgress, WorkingPlan } from "../../planning/working-plan.ts";
import { stockIssues } from "../../sim/issues.ts";
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
  /** Tools of `shop` that the operator's table lacks. */
  readonly usualTools: readonly number[];
  readonly ncLanguage: NcLanguage;
  readonly shop: Pick<Request, "table" | "rapid" | "control" | "machine">;
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

/** What a part in its clamping is planned from. */
export function requestOf(order: PlanOrder, setup: WorkingPlan["setup"]): PlanRequest {
  const { table, rapid, control, machine } = order.shop;
  return {
    ...setup,
    shop: { ...table, rapid, control, ...(machine && { machine }) },
    material: order.part.material,
    rules: { ...USUAL_RULES, ...order.part.rules },
    partsOff: order.part.partsOff,
    withoutCycles: order.withoutCycles,
    withoutTools: order.withoutTools,
    usualTools: order.usualTools,
    labels: ncLabels(order.ncLanguage),
    titles: planTitles(order.ncLanguage),
  };
}

/** Searches the working plan of a part. `tell` gets the best plan so far. */
export async function planOfPart(
  order: PlanOrder,
  changes: PlanChanges,
  tell: (progress: PlanProgress) => void,
): Promise<PlanAnswer> {
  const mine = ++orders.newest;
  const { part, blank, clamping, problems } = plannedPart(order.part);
  if (!part) return { kind: "noPart", problems };
  const search = planning(requestOf(order, { part, blank, clamping }), changes);
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

/** What an operation does, and what was found in its run, the gravest first. */
export interface ValuesTried {
  readonly tried: TriedAction;
  readonly issues: readonly AnyIssue[];
}

/** An operation with values set by hand on the stock before it. */
export function tryValues(
  order: PlanOrder,
  setup: WorkingPlan["setup"],
  stock: readonly Ring[],
  action: Action,
  values: HandValues,
): ValuesTried {
  const request = requestOf(order, setup),
    changed = withHandValues(action, values);
  const ran = runAction(changed, { stock }, request, true);
  // What it leaves is compared with the planned values, and is for a later operation.
  const issues = [...ran.made.issues, ...stockIssues(ran.simulation)]
    .map(({ issue }) => issue)
    .filter(({ code }) => code !== "materialLeft");
  const of = (severity: AnyIssue["severity"]) => issues.filter((issue) => issue.severity === severity);
  return {
    tried: applyAction(changed, { stock }, request, ran),
    issues: [...of("error"), ...of("warning")],
  };
}

/** Stops the search in progress. */
export function stopPlanning(): void {
  orders.newest += 1;
}
