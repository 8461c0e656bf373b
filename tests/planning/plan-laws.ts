import { ncLabels } from "../../src/i18n/nc-labels.ts";
import { actionSources } from "../../src/planning/actions/index.ts";
import { areaBeyond } from "../../src/planning/apply-action.ts";
import { LEAST_REGION } from "../../src/planning/open-regions.ts";
import type { FinishedPart } from "../../src/planning/part/finished-part.ts";
import { plannedPart } from "../../src/planning/part/planned-part.ts";
import { planning } from "../../src/planning/plan.ts";
import {
  actionsIn,
  compareEnds,
  firstNode,
  nodeBehind,
  type PlanNode,
  type Searching,
} from "../../src/planning/plan-node.ts";
import { USUAL_RULES } from "../../src/planning/shop-rules.ts";
import { Trade } from "../../src/planning/trade-rules.ts";
import { Tries } from "../../src/planning/tries.ts";
import { ACTION_KINDS, type PlanRequest } from "../../src/planning/types.ts";
import type { PlanChanges, WorkingPlan } from "../../src/planning/working-plan.ts";
import { standardDrills } from "../../src/program/tools/standard-drills.ts";
import { readList, shippedList } from "../../src/program/tools/tool-list.ts";

/** The built-in tools and the usual drills. */
const { table } = readList([
  ...shippedList,
  ...standardDrills(shippedList).map((cells, i) => ({ id: `drill${i}`, cells })),
]);

/** What a part is planned from; null where the part is none. */
export function requestOf(file: FinishedPart): PlanRequest | null {
  const { part, blank, clamping } = plannedPart(file);
  return (
    part && {
      part,
      blank,
      clamping,
      shop: { ...table, rapid: 10_000 },
      material: file.material,
      rules: { ...USUAL_RULES, ...file.rules },
      partsOff: file.partsOff,
      withoutCycles: [],
      withoutTools: [],
      labels: ncLabels("en"),
    }
  );
}

/** A search to its end. */
export function planOf(request: PlanRequest, changes: PlanChanges = {}): WorkingPlan {
  const search = planning(request, changes);
  for (;;) {
    const next = search.next();
    if (next.done) return next.value;
  }
}

export const keysOf = ({ steps }: WorkingPlan): readonly string[] => steps.map(({ tried }) => tried.action.key);

const searching = (request: PlanRequest): Searching => ({
  request,
  sources: actionSources,
  tries: new Tries(request),
  trade: new Trade(request),
  hand: new Map(),
  most: Infinity,
  known: new Map(),
});

/** The plan of a fixed table of sequences: kinds in their usual order, of each the first way that works. */
function fixedSequence(request: PlanRequest, s: Searching): PlanNode {
  let node = firstNode(s);
  for (const kind of ACTION_KINDS)
    for (;;) {
      const from: PlanNode = node;
      const works = actionsIn(from, s)
        .filter((a) => a.kind === kind && (kind !== "partOff" || request.partsOff))
        .map((a) => s.tries.of(a, from))
        .find((t) => t.works);
      if (!works) break;
      node = nodeBehind(from, works, s);
    }
  return node;
}

/** The end of a plan as a node of a search. */
function endOf({ steps }: WorkingPlan, s: Searching): PlanNode {
  let node = firstNode(s);
  for (const { tried } of steps) node = nodeBehind(node, tried, s);
  return node;
}

/** What a plan breaks of what every plan keeps; empty where it breaks nothing. */
export function brokenByPart(request: PlanRequest): readonly string[] {
  const plan = planOf(request);
  const s = searching(request);
  const end = endOf(plan, s);
  const fixed = fixedSequence(request, s);
  const open = actionsIn(end, s).filter((a) => {
    const tried = s.tries.of(a, end);
    return tried.works && areaBeyond(end.open, tried.stock) > LEAST_REGION;
  });
  const again = planOf(request);
  const kept = planOf(request, { keep: keysOf(plan) });
  return [
    ...(plan.steps.length > 0 && plan.judged.verdict !== "proved"
      ? [`not proved: ${JSON.stringify(plan.judged.reasons[0])}`]
      : []),
    ...(plan.gouge > 0.01 ? [`gouge ${plan.gouge}`] : []),
    ...open.map(({ key }) => `left for ${key}`),
    ...(compareEnds(fixed, end) < 0 ? [`worse than the fixed sequence: ${end.cost} s, ${fixed.cost} s`] : []),
    ...(again.text === plan.text ? [] : ["another plan of the same request"]),
    ...(kept.text === plan.text ? [] : ["another plan when nothing changed"]),
    ...(kept.tries <= plan.tries ? [] : ["more tries when nothing changed"]),
  ];
}
