import type { ShapeRequest } from "../../cycles/shape-request.ts";
import { areaOf } from "../../kernel/area/area.ts";
import { intersection, opened } from "../../kernel/area/clip.ts";
import type { Issue, Reason } from "../../kernel/plan/issue.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { SLIVER } from "../../kernel/tolerance.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { parse } from "../../nc/parse.ts";
import { hasAngleOf } from "../../program/tools/thread-tool.ts";
import type { Shop } from "../../program/state/shop.ts";
import type { RunFinding } from "../../program/state/run-types.ts";
import { run } from "../../program/run/run.ts";
import { requestedText } from "../../program/job/requested-text.ts";
import { requestedArea } from "../../program/job/requested-shape.ts";
import { simulate } from "../../sim/simulate.ts";
import { verdictOf, type Judged } from "../verdict.ts";
import type { Proposal } from "./ways.ts";

/** The result of one option to make the wanted shape. */
export interface TriedOption {
  readonly id: string;
  readonly passes: number;
  readonly seconds: number;
  /** Residual material, mm²: the same measure for every option. Null for a thread, whose form is no area. */
  readonly residualArea: number | null;
  /** Reasons for the residual material, the largest first. */
  readonly reasons: readonly { readonly reason: Reason; readonly area: number }[];
  readonly judged: Judged;
  /** Errors and warnings, the gravest first. */
  readonly issues: readonly RunFinding["issue"][];
  /** Most of the shape is left: no valid option, whatever the verdict. */
  readonly leavesMost: boolean;
  /** The residual material besides what the nose radius leaves in corners, mm²: that is for finishing. */
  readonly unreached: number;
  /** Its tool suits the depth. */
  readonly suitsDepth: boolean;
  /** True when the option cuts without faults. */
  readonly works: boolean;
}

/** Greatest share of the wanted area that may be left. */
const MOST_LEFT = 0.5;

const WEIGHT: Readonly<Record<Issue["severity"], number>> = { error: 0, warning: 1, info: 2 };

function summed(residual: readonly { readonly reason: Reason; readonly area: number }[]): TriedOption["reasons"] {
  const sums = new Map<Reason, number>();
  for (const { reason, area } of residual) sums.set(reason, (sums.get(reason) ?? 0) + area);
  return [...sums].map(([reason, area]) => ({ reason, area })).sort((a, b) => b.area - a.area);
}

/**
 * Runs the program of one option and measures its residual material; `stock`: the stock in the chuck, where it is no
 * plain blank.
 */
export function tryWay(
  { id, job, tool, suitsDepth }: Proposal,
  wanted: ShapeRequest,
  stock: readonly Ring[] | null,
  shop: Shop,
): TriedOption {
  const made = run(parse(requestedText(job, wanted, ncLabels(job.ncLanguage))), shop);
  const simulation = simulate(stock ? { ...made, blank: stock } : made);
  const judged = verdictOf(made, simulation);
  const target = requestedArea(wanted);
  const [operation] = made.operations;
  const issues = made.issues
    .map((f) => f.issue)
    .filter((i) => i.severity !== "info")
    .sort((a, b) => WEIGHT[a.severity] - WEIGHT[b.severity]);
  const residualArea = target ? areaOf(opened(intersection(simulation.final, [target]), SLIVER)) : null;
  const all = target ? areaOf(intersection(simulation.blank, [target])) : 0;
  const leavesMost = residualArea !== null && residualArea > all * MOST_LEFT;
  const reasons = summed(simulation.proof.residual);
  const corners = reasons.find(({ reason }) => reason === "insertRadius")?.area ?? 0;
  return {
    id,
    suitsDepth,
    unreached: Math.max(0, (residualArea ?? 0) - corners),
    passes: operation?.plan.passes ?? 0,
    seconds: made.seconds,
    residualArea,
    reasons,
    judged,
    issues,
    leavesMost,
    works: judged.verdict === "proved" && !leavesMost && (!wanted.thread || hasAngleOf(wanted.thread, tool)),
  };
}
