import type { Cycle, Given } from "../../cycles/define.ts";
import type { Params } from "../../cycles/params.ts";
import type { AnswerCache } from "../../kernel/answer-cache.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import type { Plan, PlanContext } from "../../kernel/plan/plan.ts";
import type { Pt, Ring } from "../../kernel/geometry/point.ts";
import { leftOnPurposeOf } from "../../cycles/left-on-purpose.ts";
import { emptyPlan } from "../../kernel/strategy/leveled.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { cycleValues } from "./cycle-values.ts";
import type { ProgramIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";
import type { Defined } from "../state/modal.ts";
import { unlikelyFeeds } from "../state/preconditions.ts";
import type { Operation } from "../state/run-types.ts";
import { countedPoint, shiftedPlan } from "./shifted-plan.ts";
import { dimensionSlip, type SlipCheckInput } from "../values/dimension-slips.ts";
import { threadWarnings } from "./thread-warnings.ts";
import { isUsualTool } from "../tools/which-tool.ts";
import { judgeOf, testedOffers } from "../values/tested-offers.ts";

/** A cycle call: besides the modal state, everything its path depends on. */
interface CalledCycle extends Pick<Given, "contour"> {
  readonly cycle: Cycle;
  readonly defined: Pick<Defined, "values" | "unknownParameters">;
  /**
   * Contour issues reported at their blocks; null where an unread block makes all other issues of the contour
   * meaningless.
   */
  readonly reportedCodes: readonly Issue["code"][] | null;
  /** Theoretical tip on the workpiece. */
  readonly start: Pt;
  /** The called tool, or its fallback. */
  readonly tool: Tool;
  /** Stock in workpiece coordinates; null while unknown. */
  readonly stock: readonly Ring[] | null;
  /** Part of the blank that is not bored yet, in workpiece coordinates. */
  readonly solid: PlanContext["solid"];
}

/** Result of a cycle call, independent of its place in the program. */
export interface CallResult extends Pick<Operation, "call" | "plan"> {
  /** Issues of values, tool and plan. */
  readonly found: readonly Issue[];
  /** The issues to report, those of the feeds included. */
  readonly reported: readonly (Issue | ProgramIssue)[];
}

const nothing: Plan = emptyPlan([]);

const unique = (issues: readonly Issue[]) => [
  ...new Map(issues.map((i) => [JSON.stringify([i.code, i.at ?? "", i.data]), i])).values(),
];

type SlipInput<P extends Params> = Omit<SlipCheckInput<P>, "setting" | "judge"> & {
  readonly given: Given;
  readonly setting: PlanContext & SlipCheckInput<P>["setting"];
};

/** A slip in the dimensions, with the planned tool or, where the table lacks the called one, with another one. */
function slipOf<P extends Params>(
  { cycle, values, given, setting, outlined, planned: issues }: SlipInput<P>,
  tools: readonly Tool[],
): readonly Issue[] | null {
  for (const tool of tools) {
    const context = { ...setting, tool };
    const judge = judgeOf(cycle, context, given);
    if (!judge) return null;
    const planned = tool === setting.tool ? issues : judge(values).issues;
    const found = dimensionSlip({ cycle, values, setting: context, judge, outlined, planned });
    if (found) return found;
  }
  return null;
}

function answer(
  machine: Machine,
  { cycle, defined, contour, reportedCodes, start: at, tool, stock: standing, solid: unbored }: CalledCycle,
): CallResult {
  const {
    spindle,
    now: { datum, toolFeed: autoFeed, tool: called },
  } = machine;
  const start = countedPoint(at, datum);
  const given: Given = { contour, start };
  const { values, partial, issues } = cycleValues(machine, cycle, defined.values);
  const counted = (rings: readonly Ring[]) => rings.map((ring) => ring.map((p) => countedPoint(p, datum)));
  const [stock, blank] = [standing && counted(standing), counted(machine.now.blank)];
  const solid = unbored
    ? { rings: counted(unbored.rings), below: unbored.below - datum.z, isBored: unbored.isBored }
    : null;
  const setting = {
    tool,
    start,
    feedUnit: machine.feedUnit,
    autoFeed,
    stock,
    skipsAirPasses: machine.run.traced !== null,
    solid,
    blank,
  };
  const plan =
    values && (cycle.contour === "own" || contour)
      ? { ...cycle.plan(values, setting, given), intendedResidual: leftOnPurposeOf(cycle, values) }
      : nothing;
  const outlined = values && plan !== nothing ? cycle.outline(values, given).issues : [];
  // A program is not blamed for issues of a fallback tool.
  const planned = called ? plan.issues : [];
  const turningOf = (made: Plan) => threadWarnings(cycle, made, spindle, machine.clock.rapid);
  const own = issues.filter((i) => i.code !== "missing" || !defined.unknownParameters.has(i.at ?? ""));
  const judge = judgeOf(cycle, called ? setting : null, given, turningOf);
  // An impossible sign or order is the cause of all other issues of tool and path.
  const tried = called ? [tool] : machine.shop.tools.filter((each) => isUsualTool(cycle.group, each));
  const slip =
    values && own.length === 0
      ? slipOf({ cycle, values, given, setting, outlined, planned: plan.issues }, tried)
      : null;
  const found = slip ?? unique([...own, ...outlined, ...planned, ...turningOf(plan)]);
  const news = found.filter((i) => i.at !== "contour" || (reportedCodes !== null && !reportedCodes.includes(i.code)));
  const offered = slip ?? testedOffers(cycle.params, partial, news, judge, start);
  const feeds =
    values && plan !== nothing
      ? unlikelyFeeds(cycle, values, plan.moves, machine, (v) => cycle.plan(v, setting, given).moves)
      : [];
  return {
    plan: shiftedPlan(slip ? { ...plan, issues: slip } : plan, datum),
    found,
    reported: [...offered, ...feeds],
    call: values && { values, given, autoFeed, start, datum },
  };
}

/** Cache key: everything that the result depends on. */
function cacheKeyOf(machine: Machine, memory: AnswerCache, asked: CalledCycle): string {
  const { cycle, defined, contour, reportedCodes, start, tool, stock, solid } = asked;
  const {
    spindle,
    clock: { rapid },
    now: { inch, datum, toolFeed, perRevolution, tool: called },
  } = machine;
  return [
    `call ${cycle.number}`,
    memory.serialized([start, datum, inch, toolFeed, perRevolution, rapid, spindle]),
    memory.serialized([
      called !== null,
      machine.run.traced !== null,
      reportedCodes,
      [...defined.values],
      [...defined.unknownParameters],
    ]),
    contour ? memory.nameOf(contour) : "",
    memory.nameOf(tool),
    stock ? memory.nameOf(stock) : "",
    solid ? `${memory.nameOf(solid.rings)} ${memory.serialized(solid.below)} ${solid.isBored}` : "",
    memory.nameOf(machine.now.blank),
  ].join("\n");
}

/** Result of a call, computed or cached from an earlier run. */
export function callResult(machine: Machine, asked: CalledCycle): CallResult {
  const { memory } = machine.shop;
  if (!memory) return answer(machine, asked);
  return memory.cached(
    cacheKeyOf(machine, memory, asked),
    () => answer(machine, asked),
    ({ plan }) => plan.moves.length,
  );
}
