import { cycleByNumber, type CycleNumber } from "../../cycles/index.ts";
import { VALUE_FORMULAS, type ValueFormula } from "../../planning/values/formulas.ts";
import type { Action, ReasonedValue } from "../../planning/types.ts";
import type { StepReason } from "../../planning/working-plan.ts";
import type { PlanTexts } from "../../i18n/en/plan.ts";
import type { Texts } from "../../i18n/index.ts";
import type { Language } from "../../i18n/languages.ts";
import { writer } from "../../i18n/write.ts";
import { durationText } from "../base/clock-text.ts";

/** The words for steps of a plan: texts of plans and of the workplaces, and the screen language. */
export interface StepWords {
  readonly t: PlanTexts;
  readonly work: Texts;
  readonly language: Language;
}

/** A time as it is written everywhere. */
export const timeWords = ({ work, language }: StepWords, seconds: number): string =>
  durationText(work.page.effect.duration, language, seconds);
/** An area with its unit. */
export const areaWords = ({ language }: StepWords, area: number): string => writer(language).area(area);

/** The cycle with its name, or path blocks. */
export function cycleWords({ t, work }: StepWords, cycle: number | null): string {
  if (cycle === null) return t.steps.pathBlocks;
  const name = cycleByNumber(cycle) ? work.cycles.of[cycle as CycleNumber].name : "";
  return `${cycle} ${name}`.trim();
}

/** A way in a few words: its cycle and its tool. */
const wayWords = ({ t }: StepWords, cycle: number | null, tool: number): string =>
  `${cycle === null ? t.steps.pathBlocks : t.steps.cycle(String(cycle))}, ${t.steps.tool(String(tool), "")}`;
/** An operation as its cycle and its tool, by their names. */
export const actionWords = (words: StepWords, { cycle, tool }: Action): string =>
  `${cycleWords(words, cycle)}, ${words.t.steps.tool(String(tool.T), tool.NAME ?? "")}`;

/** Why a step is what it is, in words. */
export function reasonWords(words: StepWords, reason: StepReason): string {
  const { because } = words.t;
  switch (reason.kind) {
    case "onlyTool":
      return because.onlyTool;
    case "onlyCycle":
      return reason.cycle === null ? because.onlyPath : because.onlyCycle;
    case "faster":
      return because.faster(timeWords(words, reason.seconds), wayWords(words, reason.cycle, reason.tool));
    case "equal":
      return because.equal(wayWords(words, reason.cycle, reason.tool));
    case "takesMore":
      return because.takesMore(areaWords(words, reason.area), wayWords(words, reason.cycle, reason.tool));
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

const isFormula = (key: string): key is ValueFormula => Object.hasOwn(VALUE_FORMULAS, key);

/** A value of a step: its name, the value, and the formula with its numbers. */
export function valueWords(
  { t, work, language }: StepWords,
  cycle: number | null,
  { q, value, formula, inputs }: ReasonedValue,
) {
  const { number } = writer(language);
  const names: Readonly<Record<string, string>> = t.values;
  const param = cycle === null ? undefined : cycleByNumber(cycle)?.params[q];
  const put = Object.entries(inputs).map(([name, n]) => `${name} = ${typeof n === "number" ? number(n) : n}`);
  return {
    name: names[q] ?? q,
    label: param ? work.params[param.text as keyof StepWords["work"]["params"]].label : "",
    value: number(value),
    formula: [isFormula(formula) ? VALUE_FORMULAS[formula] : formula, put.join(", ")].filter(Boolean).join("; "),
  };
}
