import { cycleByNumber, type CycleNumber } from "../../../cycles/index.ts";
import type { SettableValue } from "../../../planning/hand-values.ts";
import type { PartProblem } from "../../../planning/part/part-problem.ts";
import type { Action } from "../../../planning/types.ts";
import type { MissingTool, StepReason, WorkingPlan } from "../../../planning/working-plan.ts";
import type { PlanTexts } from "../../../i18n/en/plan.ts";
import type { Texts } from "../../../i18n/index.ts";
import type { Language } from "../../../i18n/languages.ts";
import { partProblemText, type PartProblemTexts } from "../../../i18n/part-problem.ts";
import { writer } from "../../../i18n/write.ts";
import { unitOf } from "../dialog/write-value.ts";
import { issueText } from "../../calculation/issue-text.ts";
import { durationText } from "../../base/clock-text.ts";

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
export function cycleName({ t, work }: PlanWords, cycle: number | null): string {
  if (cycle === null) return t.steps.pathBlocks;
  const name = cycleByNumber(cycle) ? work.cycles.of[cycle as CycleNumber].name : "";
  return `${cycle} ${name}`.trim();
}

/** Designation of a thread, without the place that its name in a plan has behind it. */
export const threadName = (id: string): string => id.replace(/ -?[\d.]+$/, "");

/** A way in a few words: its cycle and its tool. */
const otherWords = ({ t }: PlanWords, cycle: number | null, tool: number): string =>
  `${cycle === null ? t.steps.pathBlocks : t.steps.cycle(String(cycle))}, ${t.steps.tool(String(tool), "")}`;
export const actionWords = (words: PlanWords, { cycle, tool }: Action): string =>
  `${cycleName(words, cycle)}, ${words.t.steps.tool(String(tool.T), tool.NAME ?? "")}`;

/** Why a step is what it is, in words. `own`: its action. */
export function reasonWords(words: PlanWords, reason: StepReason, own: Action): string {
  const { because } = words.t;
  const wayWords = (cycle: number | null, tool: number): string =>
    cycle === own.cycle && tool === own.tool.T ? because.samePath : otherWords(words, cycle, tool);
  switch (reason.kind) {
    case "onlyTool":
      return because.onlyTool;
    case "onlyCycle":
      return reason.cycle === null ? because.onlyPath : because.onlyCycle;
    case "faster":
      return because.faster(timeWords(words, reason.seconds), wayWords(reason.cycle, reason.tool));
    case "equal":
      return because.equal(wayWords(reason.cycle, reason.tool));
    case "takesMore":
      return because.takesMore(areaWords(words, reason.area), wayWords(reason.cycle, reason.tool));
    case "sameTool":
      return because.sameTool;
    case "rule":
      return because.rules[reason.rule];
    case "rest":
      return because.rest(reason.step + 1);
    case "byHand":
      return because.byHand;
  }
}

/** Label and unit of a value that is no parameter of a cycle. */
function placeWords({ t, work: { setup, dialog } }: PlanWords, { job }: Action, q: string): readonly [string, string] {
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
export function settableWords(words: PlanWords, action: Action, { q, value, planned }: SettableValue) {
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
  const what = [...(threads > 0 ? [result.threads(threads)] : []), ...(area > 0 ? [areaWords(words, area)] : [])];
  const [first, second] = what;
  if (first !== undefined) return bad(result.left(second === undefined ? first : result.threadsAndArea(first, second)));
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
