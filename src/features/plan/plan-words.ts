import { cycleByNumber, type CycleNumber } from "../../cycles/index.ts";
import { VALUE_FORMULAS, type ValueFormula } from "../../planning/values/formulas.ts";
import type { PartProblem } from "../../planning/part/part-problem.ts";
import type { Action, ReasonedValue } from "../../planning/types.ts";
import type { MissingTool, StepReason, WorkingPlan } from "../../planning/working-plan.ts";
import type { PlanTexts } from "../../i18n/en/plan.ts";
import type { Texts } from "../../i18n/index.ts";
import type { Language } from "../../i18n/languages.ts";
import {
  missingToolText,
  planReasonText,
  planVerdict,
  regionPlaceText,
  type PlanVerdict,
  type PlanWriter,
} from "../../i18n/plan-text.ts";
import { partProblemText, type PartProblemTexts } from "../../i18n/part-problem.ts";
import { writer } from "../../i18n/write.ts";
import { issueText } from "../../app/calculation/issue-text.ts";
import { durationText } from "../../app/base/clock-text.ts";

/** The words of the page: its own texts, those of the workplaces and of problems of a part, and the screen language. */
export interface PlanWords {
  readonly t: PlanTexts;
  readonly work: Texts;
  readonly problems: PartProblemTexts;
  readonly language: Language;
}

export const timeWords = ({ work, language }: PlanWords, seconds: number): string =>
  durationText(work.page.effect.duration, language, seconds);
export const areaWords = ({ language }: PlanWords, area: number): string => writer(language).area(area);

/** The cycle with its name, or path blocks. */
export function cycleWords({ t, work }: PlanWords, cycle: number | null): string {
  if (cycle === null) return t.steps.pathBlocks;
  const name = cycleByNumber(cycle) ? work.cycles.of[cycle as CycleNumber].name : "";
  return `${cycle} ${name}`.trim();
}

/** Designation of a thread, without the place that its name in a plan has behind it. */
export const threadName = (id: string): string => id.replace(/ -?[\d.]+$/, "");

/** The same words for the sentences that the command has, too. */
const writerOf = (words: PlanWords): PlanWriter => ({
  t: words.t,
  language: words.language,
  time: (seconds) => timeWords(words, seconds),
});

export const actionWords = (words: PlanWords, { cycle, tool }: Action): string =>
  `${cycleWords(words, cycle)}, ${words.t.steps.tool(String(tool.T), tool.NAME ?? "")}`;

/** Why a step is what it is, in words. */
export const reasonWords = (words: PlanWords, reason: StepReason): string => planReasonText(writerOf(words), reason);

const isFormula = (key: string): key is ValueFormula => Object.hasOwn(VALUE_FORMULAS, key);

/** A value of a step: its name, the value, and the formula with its numbers. */
export function valueWords(
  { t, work, language }: PlanWords,
  cycle: number | null,
  { q, value, formula, inputs }: ReasonedValue,
) {
  const { number } = writer(language);
  const names: Readonly<Record<string, string>> = t.values;
  const param = cycle === null ? undefined : cycleByNumber(cycle)?.params[q];
  const put = Object.entries(inputs).map(([name, n]) => `${name} = ${typeof n === "number" ? number(n) : n}`);
  return {
    name: names[q] ?? q,
    label: param ? work.params[param.text as keyof PlanWords["work"]["params"]].label : "",
    value: number(value),
    formula: [isFormula(formula) ? VALUE_FORMULAS[formula] : formula, put.join(", ")].filter(Boolean).join("; "),
  };
}

/** The smallest data of a missing tool, in words. */
export const missingWords = (words: PlanWords, tool: MissingTool): string => missingToolText(writerOf(words), tool);

/** Time of tool changes in a plan, s. The time of its program has them only where the machine data state one. */
export const changeSeconds = ({ steps }: WorkingPlan): number =>
  steps.reduce((sum, { seconds, tried }) => sum + seconds - tried.seconds, 0);

/** What a plan achieves, in a few words: the verdict is that of its whole program. */
export const verdictWords = (words: PlanWords, plan: WorkingPlan): PlanVerdict => planVerdict(writerOf(words), plan);

/** A problem of a part in words; `numberOf`: the number of a row in its table. */
export function problemWords(
  { work, problems, language }: PlanWords,
  problem: PartProblem,
  numberOf: (row: string) => number,
): string {
  const numbered = problem.row === undefined ? problem : { ...problem, row: String(numberOf(problem.row)) };
  return partProblemText(language, numbered, problems, (issue) => issueText(work, language, issue, null));
}

/** The place of a region, as Z of its ends. */
export const regionPlace = regionPlaceText;
