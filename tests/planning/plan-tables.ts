import type { FinishedPart } from "../../src/planning/part/finished-part.ts";
import type { WorkingPlan } from "../../src/planning/working-plan.ts";
import { partByHand, PROGRAMMED_BY_HAND } from "./by-hand.ts";
import { PART_NAMES, partOfTrade, PEER_NAMES } from "./parts.ts";
import { planOf, requestOf, unprepared } from "./plan-laws.ts";

/** A plan with the processor time of its search, ms. */
function measured(part: FinishedPart): { readonly plan: WorkingPlan; readonly ms: number } {
  const request = requestOf(part);
  if (!request) throw new Error(part.name);
  const before = process.cpuUsage();
  const plan = planOf(request);
  return { plan, ms: process.cpuUsage(before).user / 1000 };
}

/** What a plan leaves: areas, mm² of the half plane, and threads, each with the reason. */
const leftWords = ({ residue }: WorkingPlan): string =>
  residue.map((r) => `${r.region?.area.toFixed(2) ?? r.missing?.thread ?? ""} ${r.site} (${r.why})`).join(", ");

/** A row of the table of plans: the names of its columns with what it says. */
export type PlanRow = readonly [
  part: string,
  verdict: string,
  complete: string,
  tools: string,
  left: string,
  steps: string,
  s: string,
];
export const PLAN_COLUMNS: PlanRow = ["part", "verdict", "complete", "tools", "left", "operations", "s"];

const completeWord = ({ isComplete, second }: WorkingPlan): string => {
  if (isComplete) return second ? "in two clampings" : "in one clamping";
  return "no";
};

/** The row of a plan. */
export const planRow = (name: string, plan: WorkingPlan): PlanRow => [
  name,
  plan.judged.verdict,
  completeWord(plan),
  plan.tools.map((T) => `T${T}`).join(" "),
  leftWords(plan),
  String(plan.steps.length),
  plan.seconds.toFixed(0),
];

/** A plan with the processor time that it took, ms, and its steps that were not prepared. */
interface TradeRow {
  readonly row: PlanRow;
  readonly ms: number;
  readonly unprepared: readonly string[];
}

/** The plans of the parts of the trade and of other controls. Yields as it plans them. */
export function* tradeRows(): Generator<TradeRow> {
  for (const name of [...PART_NAMES, ...PEER_NAMES]) {
    const { plan, ms } = measured(partOfTrade(name));
    yield { row: planRow(name, plan), ms, unprepared: unprepared(plan) };
  }
}

/** The parts that were programmed by hand, a line each, times without tool changes. */
export function* handTable(): Generator<string> {
  yield "| part | by hand, s | planned, s | ratio | left |\n|---|---:|---:|---:|---|";
  for (const made of PROGRAMMED_BY_HAND) {
    const { plan } = measured(partByHand(made));
    const { programSeconds: s } = plan;
    yield `| ${made.name} | ${made.seconds.toFixed(1)} | ${s.toFixed(1)} | ${(s / made.seconds).toFixed(2)} | ${leftWords(plan)} |`;
  }
}
