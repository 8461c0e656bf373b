import type { Shape } from "../shape.ts";

/** A learner's working plan beside that of the planner. Numbers arrive as text of the language. */
export const planComparison = {
  title: "Two plans for one part",
  about:
    "The planner has made a plan for the same drawing with the same tools. Neither plan is the only right one: each difference was tried in your program, and the whole part was checked again.",
  planning: (tries: number) => `The planner is at work: ${tries} operations tried`,
  trying: (n: number) => `Trying the planner’s way in your program: difference ${n}`,
  failed: "The comparison could not be calculated.",
  noPlan: "This drawing cannot be planned.",
  noProgram: "Your program has no operation yet.",
  again: "Try again",
  yours: "Your plan",
  planner: "Planner",
  whole: "The whole part",
  facts: { time: "Time", changes: "Tool changes", tools: "Tools", left: "Residual material", goals: "Goals" },
  met: "all met",
  missed: (goals: string) => `not met: ${goals}`,
  withChanges: (time: string) => `Times contain ${time} for each tool change.`,
  summary: (differences: number, planner: number, own: number) =>
    differences === 0
      ? "Both plans do the same."
      : `Differences tried: ${differences}. The planner’s way is better in ${planner}, yours in ${own}.`,
  rows: "Operation by operation",
  onlyYours: "only in your plan",
  onlyPlanner: "only in the planner’s plan",
  nothing: "no such operation",
  number: (n: number) => `No. ${n}`,
  thread: "thread",
  differs: {
    same: "same tool, same cycle",
    tool: "other tool",
    cycle: "other cycle",
    count: (own: number, planner: number) => `${own} : ${planner} operations`,
    earlier: "planner does it earlier",
    later: "planner does it later",
    faster: (time: string) => `yours ${time} faster`,
    slower: (time: string) => `planner ${time} faster`,
    sameTime: "same time",
  },
  why: "Why the planner does it so",
  values: { title: "Different values", value: "Value", reason: "The planner’s formula" },
  tried: {
    way: "Your program with the planner’s way",
    order: "Your program in the planner’s order",
    none: "Could not be written into your program.",
    time: (time: string, difference: string) => `${time} (${difference})`,
    left: (area: string) => `${area} residual material`,
    clean: "no residual material",
    changes: (n: number) => (n === 1 ? "1 tool change" : `${n} tool changes`),
    better: { own: "Your way is better", other: "The planner’s way is better", same: "No difference in the result" },
  },
};

export type PlanComparisonTexts = Shape<typeof planComparison>;
