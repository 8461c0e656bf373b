import { cycleByNumber, type CycleNumber } from "../../../cycles/index.ts";
import type { SettableValue } from "../../../planning/hand-values.ts";
import type { PartProblem } from "../../../planning/part/part-problem.ts";
import type { Action } from "../../../planning/types.ts";
import type { MissingTool, OtherWay, StepReason, WorkingPlan } from "../../../planning/working-plan.ts";
import {
  missingToolText,
  planDifferenceText,
  planReasonText,
  planVerdict,
  regionPlaceText,
  type PlanVerdict,
  type PlanWriter,
} from "../../../i18n/plan-text.ts";
import type { PlanTexts } from "../../../i18n/en/plan.ts";
import type { Texts } from "../../../i18n/index.ts";
import type { Language } from "../../../i18n/languages.ts";
import { partProblemText, type PartProblemTexts } from "../../../i18n/part-problem.ts";
import { writer } from "../../../i18n/write.ts";
import { unitOf } from "../dialog/write-value.ts";
import { issueText } from "../../calculation/issue-text.ts";
import { durationText } from "../../base/clock-text.ts";

/** The words for operations of a plan: texts of plans and of the workplaces, and the screen language. */
export interface StepWords {
  readonly t: PlanTexts;
  readonly work: Texts;
  readonly language: Language;
}

/** The words of the page: those for operations, and of problems of a part. */
export interface PlanWords extends StepWords {
  readonly problems: PartProblemTexts;
}

export const timeWords = ({ work, language }: StepWords, seconds: number): string =>
  durationText(work.page.effect.duration, language, seconds);
export const areaWords = ({ language }: StepWords, area: number): string => writer(language).area(area);

/** The cycle with its name, or path blocks; a drilling cycle of the control has a number only. */
export function cycleName({ t, work }: StepWords, cycle: number | null): string {
  if (cycle === null) return t.steps.pathBlocks;
  return cycleByNumber(cycle) ? `${cycle} ${work.cycles.of[cycle as CycleNumber].name}` : t.steps.cycle(String(cycle));
}

/** Designation of a thread, without the place that its name in a plan has behind it. */
export const threadName = (id: string): string => id.replace(/ -?[\d.]+$/, "");

/** The same words for the sentences that the command has, too. */
const writerOf = (words: StepWords): PlanWriter => ({
  t: words.t,
  language: words.language,
  time: (seconds) => timeWords(words, seconds),
});

export const actionWords = (words: StepWords, { cycle, tool }: Action): string =>
  `${cycleName(words, cycle)}, ${words.t.steps.tool(String(tool.T), tool.NAME ?? "")}`;

/** Why a step is what it is, in words. `own`: its action. */
export const reasonWords = (words: StepWords, reason: StepReason, own: Action): string =>
  planReasonText(writerOf(words), reason, own);

/** How another way differs, in words. */
export const differenceWords = (words: StepWords, way: Pick<OtherWay, "longer" | "leaves">): string =>
  planDifferenceText(writerOf(words), way);

/** Label and unit of a value that is no parameter of a cycle. */
function placeWords({ t, work: { setup, dialog } }: StepWords, { job }: Action, q: string): readonly [string, string] {
  const { spindle, start, units } = setup;
  switch (q) {
    case "speed":
      return job.spindle.mode === "constant" ? [spindle.speed, units.rpm] : [spindle.cuttingSpeed, units.cuttingSpeed];
    case "limit":
      return [spindle.limit, units.rpm];
    case "start.x":
      return [start.x, units.diameter];
    case "start.z":
      return [start.z, units.mm];
    case "feed":
      return [t.steps.feed, dialog.units.perRevolution];
    default:
      return [q, ""];
  }
}

/** A value of an operation in words: its name, unit and choices, and what was planned. */
export function settableWords(words: StepWords, action: Action, { q, value, planned }: SettableValue) {
  const { t, work, language } = words;
  const param = action.cycle === null || action.cut ? undefined : cycleByNumber(action.cycle)?.params[q];
  const own = param && work.params[param.text as keyof Texts["params"]];
  const meanings: Readonly<Record<number, string>> = own && "choices" in own ? own.choices : {};
  const [label, unit] = placeWords(words, action, q);
  return {
    name: param ? q : "",
    label: own ? own.label : label,
    unit: param ? work.dialog.units[unitOf(param, action.job.perRevolution)] : unit,
    choices: param?.choices?.map((n) => ({ value: String(n), meaning: meanings[n] ?? "" })) ?? null,
    planned: planned === value ? "" : t.steps.planned(writer(language).number(planned)),
  };
}

/** The smallest data of a missing tool, in words. */
export const missingWords = (words: StepWords, tool: MissingTool): string => missingToolText(writerOf(words), tool);

/** Time of tool changes in a plan, s. The time of its program has them only where the machine data state one. */
export const changeSeconds = ({ steps }: WorkingPlan): number =>
  steps.reduce((sum, { seconds, tried }) => sum + seconds - tried.seconds, 0);

/** What a plan achieves, in a few words: the verdict is that of its whole program. */
export const verdictWords = (words: StepWords, plan: WorkingPlan): PlanVerdict => planVerdict(writerOf(words), plan);

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
