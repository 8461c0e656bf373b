import type { PartProblem } from "../../planning/part/part-problem.ts";
import type { MissingTool, WorkingPlan } from "../../planning/working-plan.ts";
import { partProblemText, type PartProblemTexts } from "../../i18n/part-problem.ts";
import { writer } from "../../i18n/write.ts";
import { issueText } from "../../app/calculation/issue-text.ts";
import { areaWords, type StepWords } from "../../app/calculation/plan-step-words.ts";

/** The words of the page: those for steps of a plan, and of problems of a part. */
export interface PlanWords extends StepWords {
  readonly problems: PartProblemTexts;
}

/** Designation of a thread, without the place that its name in a plan has behind it. */
export const threadName = (id: string): string => id.replace(/ -?[\d.]+$/, "");

/** The smallest data of a missing tool, in words. */
export function missingWords({ t, language }: PlanWords, tool: MissingTool): string {
  const { left } = t,
    { length, angle } = writer(language);
  const said = [
    left.forms[tool.form],
    left.where[tool.site],
    tool.hand && left[tool.hand],
    tool.thread !== undefined && left.forThread(tool.thread),
    tool.descends !== undefined && left.descends(angle(tool.descends)),
    tool.mostNose !== undefined && left.mostNose(length(tool.mostNose)),
    tool.mostWidth !== undefined && left.mostWidth(length(tool.mostWidth)),
    tool.leastDepth !== undefined && left.leastDepth(length(tool.leastDepth)),
    tool.mostDiameter !== undefined && left.mostDiameter(length(tool.mostDiameter)),
    tool.leastReach !== undefined && left.leastReach(length(tool.leastReach)),
  ];
  return said.filter(Boolean).join(", ");
}

/** Time of tool changes in a plan, s. The time of its program has them only where the machine data state one. */
export const changeSeconds = ({ steps }: WorkingPlan): number =>
  steps.reduce((sum, { seconds, tried }) => sum + seconds - tried.seconds, 0);

/** What a plan achieves, in a few words: the verdict is that of its whole program. */
export function verdictWords(
  words: PlanWords,
  plan: WorkingPlan,
): { readonly text: string; readonly isGood: boolean; readonly isProved: boolean } {
  const { result } = words.t;
  const isProved = plan.judged.verdict === "proved" && plan.gouge <= 0.01;
  const bad = (text: string) => ({ text, isGood: false, isProved });
  if (plan.judged.verdict === "faults") return bad(result.faults);
  if (plan.gouge > 0.01) return bad(result.damage(areaWords(words, plan.gouge)));
  if (plan.steps.length === 0) return bad(words.t.run.none);
  if (plan.judged.verdict === "incomplete") return bad(result.unchecked);
  const open = plan.residue.filter(({ why }) => why !== "rear" && why !== "clamping");
  const threads = open.filter(({ region }) => region === null).length,
    area = open.reduce((sum, { region }) => sum + (region?.area ?? 0), 0);
  if (threads > 0) return bad(result.notMade(threads));
  if (area > 0) return bad(result.left(areaWords(words, area)));
  return { text: plan.residue.length > 0 ? result.rest : result.complete, isGood: plan.isComplete, isProved };
}

/** A problem of a part in words; `numberOf`: the number of a row in its table. */
export function problemWords(
  { work, problems, language }: PlanWords,
  problem: PartProblem,
  numberOf: (row: string) => number,
): string {
  const numbered = problem.row === undefined ? problem : { ...problem, row: String(numberOf(problem.row)) };
  return partProblemText(language, numbered, problems, (issue) => issueText(work, language, issue, null));
}

/** The place of a region, as Z of its ends and its diameters. */
export const regionPlace = (
  { t, language }: PlanWords,
  box: { readonly left: number; readonly right: number },
): string => t.left.at(writer(language).signed(box.right), writer(language).signed(box.left));
