import type { RuleName, TaskJudgement, TaskMark } from "./judge/judgement.ts";
import type { Task, TaskRules, TaskSize } from "./task.ts";

/** One goal of a task, a line of its list of goals. */
export type TaskGoal =
  | { readonly kind: "predicted"; readonly entry: number; readonly of: number }
  | { readonly kind: "part"; readonly residue: number | null }
  | { readonly kind: "size"; readonly entry: number; readonly size: TaskSize }
  | {
      readonly kind: "safe" | "clean";
    }
  | { readonly kind: "depth" | "speed" | "mostTools" | "seconds" | "passes"; readonly limit: number }
  | { readonly kind: "tools"; readonly tools: readonly number[] }
  | { readonly kind: "cycles" | "without"; readonly cycle: number }
  | { readonly kind: "values"; readonly entry: number; readonly asked: NonNullable<TaskRules["values"]>[number] }
  | { readonly kind: "rz"; readonly entry: number; readonly asked: NonNullable<TaskRules["rz"]>[number] }
  | { readonly kind: "words"; readonly entry: number; readonly word: string };

/** Residue that no goal mentions, mm²: an insert leaves about this much in a sharp corner. */
const UNMENTIONED_RESIDUE = 0.05;

/** The goals of a task, in the order of its list. */
export function goalsOf({ kind, part, sizes = [], rules, predict = [] }: Task): readonly TaskGoal[] {
  const predicted = predict.map((_, entry): TaskGoal => ({ kind: "predicted", entry, of: predict.length }));
  if (kind === "predict") return predicted;
  const residue = rules.residue ?? 0;
  const limits = (["depth", "speed", "passes", "seconds", "mostTools"] as const).flatMap((name): TaskGoal[] => {
    const limit = rules[name];
    return limit === undefined ? [] : [{ kind: name, limit }];
  });
  return [
    ...predicted,
    ...(part ? [{ kind: "part" as const, residue: residue > UNMENTIONED_RESIDUE ? residue : null }] : []),
    ...sizes.map((size, entry): TaskGoal => ({ kind: "size", entry, size })),
    ...(rules.rz ?? []).map((asked, entry): TaskGoal => ({ kind: "rz", entry, asked })),
    { kind: "safe" },
    ...(rules.clean ? [{ kind: "clean" as const }] : []),
    ...limits,
    ...(rules.tools ? [{ kind: "tools" as const, tools: rules.tools }] : []),
    ...(["cycles", "without"] as const).flatMap((name) =>
      (rules[name] ?? []).map((cycle): TaskGoal => ({ kind: name, cycle })),
    ),
    ...(rules.values ?? []).map((asked, entry): TaskGoal => ({ kind: "values", entry, asked })),
    ...(rules.words ?? []).map((word, entry): TaskGoal => ({ kind: "words", entry, word })),
  ];
}

const TOGETHER: Readonly<Partial<Record<TaskGoal["kind"], readonly RuleName[]>>> = {
  part: ["blank", "missing", "residue"],
  safe: ["errors", "unproved", "rapid", "holder", "gouge"],
};

function isAbout(goal: TaskGoal, mark: TaskMark): boolean {
  const { rule, size, entry, about } = mark;
  switch (goal.kind) {
    case "predicted":
      return false;
    case "part":
    case "safe":
      return TOGETHER[goal.kind]?.includes(rule) ?? false;
    case "size":
      return rule === "size" && size === goal.entry;
    case "values":
    case "rz":
    case "words":
      return rule === goal.kind && entry === goal.entry;
    case "cycles":
    case "without":
      return rule === goal.kind && (about === undefined || about === goal.cycle);
    default:
      return rule === goal.kind;
  }
}

/** The marks of a judgement that fail a goal. */
export const marksOn = (goal: TaskGoal, judgement: TaskJudgement | null): readonly TaskMark[] =>
  judgement?.marks.filter((mark) => !mark.passed && isAbout(goal, mark)) ?? [];

/** A size or a surface of the drawing, with its failed marks. */
export interface DrawnGoal {
  readonly goal: TaskGoal;
  readonly marks: readonly TaskMark[];
}

const isDrawn = ({ kind }: TaskGoal): boolean => kind === "size" || kind === "rz";

/** The goals as the list counts them: with a drawing, its sizes and surfaces are one goal. */
export function countGoals(
  goals: readonly TaskGoal[],
  hasDrawing: boolean,
  met: (goal: TaskGoal) => boolean,
): { readonly open: number; readonly all: number } {
  const drawn = goals.filter(isDrawn);
  const isGathered = hasDrawing && drawn.length > 1;
  const rows = isGathered
    ? [...goals.filter((goal) => !isDrawn(goal)).map((goal) => [goal]), drawn]
    : goals.map((g) => [g]);
  return { open: rows.filter((row) => !row.every(met)).length, all: rows.length };
}

/** Splits the goals into those before the drawing, those in the drawing (unmet ones first) and those after it. */
export function groupGoals(
  goals: readonly TaskGoal[],
  judgement: TaskJudgement | null,
): { readonly before: readonly TaskGoal[]; readonly drawn: readonly DrawnGoal[]; readonly after: readonly TaskGoal[] } {
  const first = goals.findIndex(isDrawn);
  if (first < 0) return { before: goals, drawn: [], after: [] };
  const drawn = goals.filter(isDrawn).map((goal) => ({ goal, marks: marksOn(goal, judgement) }));
  return {
    before: goals.slice(0, first),
    drawn: [...drawn.filter(({ marks }) => marks.length > 0), ...drawn.filter(({ marks }) => marks.length === 0)],
    after: goals.slice(first).filter((goal) => !isDrawn(goal)),
  };
}

/** Whether a goal is met: by the predictions (each right or not), or else by the judgement of the program. */
export const isMet = (goal: TaskGoal, judgement: TaskJudgement | null, predicted: readonly boolean[]): boolean =>
  goal.kind === "predicted"
    ? predicted[goal.entry] === true
    : judgement !== null && marksOn(goal, judgement).length === 0;
