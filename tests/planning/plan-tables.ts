import type { FinishedPart } from "../../src/planning/part/finished-part.ts";
import type { WorkingPlan } from "../../src/planning/working-plan.ts";
import { partByHand, PROGRAMMED_BY_HAND } from "./by-hand.ts";
import { PART_NAMES, partOfTrade } from "./parts.ts";
import { planOf, requestOf } from "./plan-laws.ts";

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

/** The parts of the trade, a line each. Yields as it plans them. */
export function* tradeTable(): Generator<string> {
  yield "| part | verdict | complete | left | operations | s | tries | CPU ms |\n|---|---|---|---|---:|---:|---:|---:|";
  for (const name of PART_NAMES) {
    const { plan, ms } = measured(partOfTrade(name));
    const complete = plan.isComplete ? "yes" : plan.second ? "with the second clamping" : "no";
    yield `| ${name} | ${plan.judged.verdict} | ${complete} | ${leftWords(plan)} | ${plan.steps.length} | ${plan.seconds.toFixed(1)} | ${plan.tries} | ${ms.toFixed(0)} |`;
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
