import { difference } from "../../kernel/area/clip.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { parse } from "../../nc/parse.ts";
import { print, type Program } from "../../nc/program.ts";
import { areaBeyond, withAction } from "../../planning/apply-action.ts";
import { comparePlans, type ComparedOperation, type ComparedRow } from "../../planning/compare-plans.ts";
import type { PlanRequest } from "../../planning/types.ts";
import type { PlanStep, WorkingPlan } from "../../planning/working-plan.ts";
import { isRefused, movedOperation, withoutOperation } from "../../program/edits/operation-edits.ts";
import { producedParts } from "../../sim/produced-parts.ts";
import { answerOf } from "../judge/answer.ts";
import { judge } from "../judge/judge.ts";
import { goalsOf, isMet, type TaskGoal } from "../goals.ts";
import type { Answer } from "../judge/judgement.ts";
import { calledTools } from "../judge/rules.ts";
import { secondsOfAnswer } from "../judge/shop.ts";
import { targetPart } from "../target-part.ts";
import type { Task } from "../task.ts";
import { programOperations, type ProgramOperation } from "./program-operations.ts";

/** What a whole program achieves in an exercise. */
export interface Achieved {
  /** Time with tool changes, s. */
  readonly seconds: number;
  readonly changes: number;
  readonly tools: readonly number[];
  /** Material outside the drawn part, mm² of the half section. */
  readonly left: number;
  /** Goals of the exercise that it misses; empty: it passes. */
  readonly missed: readonly TaskGoal[];
}

/** A change of the own program that was run and judged as a whole. */
export interface TriedChange extends Achieved {
  /** The way of the other plan in place of the own operations, or only its order. */
  readonly kind: "way" | "order";
  readonly text: string;
}

/** A row with what the difference came to in the own program; empty where nothing differs or nothing could be written. */
export interface PlanRow extends ComparedRow {
  readonly tried: readonly TriedChange[];
}

/** The own plan beside that of the planner. */
export interface PlanComparison {
  readonly own: { readonly operations: readonly ProgramOperation[]; readonly achieved: Achieved };
  readonly planned: { readonly steps: readonly PlanStep[]; readonly achieved: Achieved };
  readonly rows: readonly PlanRow[];
}

/** Differences of time that are none: s, and part of the longer time. */
const SAME = { seconds: 0.5, share: 0.01 };
/** Whether two times are practically the same, s. */
export const isSameTime = (a: number, b: number): boolean =>
  Math.abs(a - b) <= Math.max(SAME.seconds, SAME.share * Math.max(a, b));

/** Smaller differences of residual material are none, mm². */
const SAME_AREA = 0.05;

/**
 * Which of two results is better: the one that meets more goals, else the one that leaves less, else the faster one.
 * "same": neither.
 */
export function betterOf(own: Achieved, other: Achieved): "own" | "other" | "same" {
  const missed = other.missed.length - own.missed.length;
  const left = other.left - own.left;
  const longer = isSameTime(own.seconds, other.seconds) ? 0 : other.seconds - own.seconds;
  const worse = missed || (Math.abs(left) < SAME_AREA ? 0 : left) || longer;
  if (worse === 0) return "same";
  return worse > 0 ? "own" : "other";
}

function achievedBy(task: Task, answer: Answer, change: number): Achieved {
  const { steps } = answer.run;
  const changes = steps.filter(({ tool }, i) => tool.T !== steps[i - 1]?.tool.T).length;
  const wanted = task.part && targetPart(task.part).rings;
  const judgement = judge(task, answer);
  return {
    seconds: secondsOfAnswer(answer) + changes * change,
    changes,
    tools: [...calledTools(answer).keys()],
    left: wanted ? areaBeyond(producedParts(answer.simulation), wanted) : 0,
    missed: goalsOf(task).filter((goal) => goal.kind !== "predicted" && !isMet(goal, judgement, [])),
  };
}

/** A step of the planner; its stock before is that of the step before it. */
const plannedOperation = ({ tried, seconds }: PlanStep, before: readonly Ring[]): ComparedOperation => {
  const { action, stock } = tried;
  const isThread = action.threads.length > 0;
  return {
    cycle: action.cycle,
    tool: action.tool.T,
    seconds,
    taken: isThread ? [] : difference(before, stock),
    thread: isThread
      ? { front: action.place.front, rear: action.place.rear, isInside: action.site === "inside" }
      : null,
  };
};

/** What the trials of one comparison have in common. */
interface Sides {
  readonly task: Task;
  readonly program: Program;
  readonly own: readonly ProgramOperation[];
  readonly steps: readonly PlanStep[];
  readonly rows: readonly ComparedRow[];
  readonly request: Pick<PlanRequest, "labels" | "clamping" | "rules" | "shop">;
}

const changeTime = ({ shop, rules }: Sides["request"]): number => shop.machine?.toolChange ?? rules.toolChange;

/** The own operations in front of a row, counted in the program. */
const ownBefore = ({ rows, own }: Sides, row: ComparedRow): number | null => {
  const last = rows
    .slice(0, rows.indexOf(row))
    .flatMap((each) => each.own)
    .at(-1);
  return row.own.length > 0
    ? (own[row.own[0] ?? 0]?.unit ?? 0) - 1
    : last === undefined
      ? null
      : (own[last]?.unit ?? null);
};

/** The own program with the operations of a row done as the other plan does them; null where that cannot be written. */
function withOtherWay(sides: Sides, row: ComparedRow): Program | null {
  const { own, steps, request } = sides;
  const units = row.own.map((i) => own[i]?.unit ?? -1).toSorted((a, b) => b - a);
  const place = ownBefore(sides, row);
  let program = sides.program;
  for (const unit of units) {
    const without = withoutOperation(program, unit);
    if (isRefused(without)) return null;
    program = without;
  }
  return row.other.reduce((made, i, n) => {
    const action = steps[i]?.tried.action;
    const behind = place === null || place < 0 ? (n === 0 ? null : n - 1) : place + n;
    return action ? withAction(made, action, request, { behind }) : made;
  }, program);
}

/** The own program with the operations of a row at their place in the order of the other plan; null where that cannot be written. */
function withOtherOrder({ rows, own, program }: Sides, row: ComparedRow): Program | null {
  const [from] = row.own;
  const both = rows.filter((each) => each.own.length > 0 && each.other.length > 0 && each !== row);
  const first = row.other[0] ?? 0;
  const neighbour =
    row.moved === "earlier"
      ? both.find((each) => (each.other[0] ?? 0) > first)?.own[0]
      : both.findLast((each) => (each.other[0] ?? 0) < first)?.own.at(-1);
  const [unit, to] = [own[from ?? -1]?.unit, own[neighbour ?? -1]?.unit];
  if (row.own.length !== 1 || unit === undefined || to === undefined || unit === to) return null;
  const moved = movedOperation(program, unit, to);
  return isRefused(moved) ? null : moved;
}

/** Whether the ways of a row differ in anything but their place. `seconds`: time of the own operations. */
const differsInWay = ({ isSameTool, isSameCycle, own, other, longer }: ComparedRow, seconds: number): boolean =>
  !isSameTool || !isSameCycle || own.length !== other.length || !isSameTime(seconds, seconds - longer);

/**
 * The plan of a learner's program beside a working plan for the same part. Every difference is tried in the learner's
 * program, which is then run and judged as a whole. Yields before each trial; pure.
 */
export function* comparingPlans(
  task: Task,
  answer: Answer,
  plan: Pick<WorkingPlan, "steps" | "text">,
  request: PlanRequest,
): Generator<number, PlanComparison> {
  const change = changeTime(request);
  const own = programOperations(answer, change);
  const stocks = [request.blank, ...plan.steps.map(({ tried }) => tried.stock)];
  const planned = plan.steps.map((step, i) => plannedOperation(step, stocks[i] ?? []));
  const rows = comparePlans(own, planned);
  const sides: Sides = { task, program: parse(answer.text), own, steps: plan.steps, rows, request };
  const tried: PlanRow[] = [];
  for (const [i, row] of rows.entries()) {
    const seconds = row.own.reduce((sum, each) => sum + (own[each]?.seconds ?? 0), 0);
    const isBegun = own.length > 0;
    const changes: readonly (readonly [TriedChange["kind"], Program | null])[] = [
      ["way", isBegun && differsInWay(row, seconds) ? withOtherWay(sides, row) : null],
      ["order", row.moved ? withOtherOrder(sides, row) : null],
    ];
    const made: TriedChange[] = [];
    for (const [kind, program] of changes) {
      if (!program) continue;
      yield i;
      const text = print(program);
      made.push({ kind, text, ...achievedBy(task, answerOf(text), change) });
    }
    tried.push({ ...row, tried: made });
  }
  return {
    own: { operations: own, achieved: achievedBy(task, answer, change) },
    planned: { steps: plan.steps, achieved: achievedBy(task, answerOf(plan.text), change) },
    rows: tried,
  };
}
