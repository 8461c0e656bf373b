import { durationText, type DurationWords } from "../src/app/base/clock-text.ts";
import { page as de } from "../src/i18n/de/first/page.ts";
import { plan as planDe } from "../src/i18n/de/plan.ts";
import { page as en } from "../src/i18n/en/first/page.ts";
import { plan as planEn, type PlanTexts } from "../src/i18n/en/plan.ts";
import { page as fr } from "../src/i18n/fr/first/page.ts";
import { plan as planFr } from "../src/i18n/fr/plan.ts";
import {
  missingToolText,
  planActionText,
  planDifferences,
  planReasonText,
  planVerdict,
  residueText,
  type PlanWriter,
} from "../src/i18n/plan-text.ts";
import { page as zh } from "../src/i18n/zh/first/page.ts";
import { plan as planZh } from "../src/i18n/zh/plan.ts";
import type { NcLanguage } from "../src/nc/nc-languages.ts";
import type { PlanStep, Residue, WorkingPlan } from "../src/planning/working-plan.ts";

/* What `npm run plan` says about a plan on standard error, in the words of the page. */

const TEXTS: Readonly<Record<NcLanguage, { readonly t: PlanTexts; readonly duration: DurationWords }>> = {
  en: { t: planEn, duration: en.effect.duration },
  de: { t: planDe, duration: de.effect.duration },
  fr: { t: planFr, duration: fr.effect.duration },
  zh: { t: planZh, duration: zh.effect.duration },
};

/** The words of the command in a language. */
export const planTextsOf = (language: NcLanguage): PlanWriter => {
  const { t, duration } = TEXTS[language];
  return { t, language, time: (seconds) => durationText(duration, language, seconds) };
};

function stepLines({ tried, seconds, why, others }: PlanStep, i: number, w: PlanWriter): readonly string[] {
  const { kinds, steps } = w.t;
  const reasons = why.map((reason) => planReasonText(w, reason)).join("; ");
  return [
    `${String(i + 1).padStart(2)}. ${kinds[tried.action.kind]}: ${planActionText(w, tried.action)}, ${w.time(seconds)}` +
      (reasons === "" ? "" : ` (${reasons})`),
    ...others.map((other) => {
      const said = planDifferences(w, other).join(", ");
      return `      ${steps.others}: ${planActionText(w, other.tried.action)}: ${said === "" ? steps.sameResult : said}`;
    }),
  ];
}

const residueLine = (residue: Residue, w: PlanWriter): string =>
  [
    `${w.t.left.title}: ${residueText(w, residue)}`,
    ...(residue.missing ? [`${w.t.left.missing}: ${missingToolText(w, residue.missing)}`] : []),
  ].join("; ");

/** A plan as lines: its steps with their reasons, what is left, time and verdict. */
export function planLines(plan: WorkingPlan, w: PlanWriter): readonly string[] {
  const { result } = w.t;
  return [
    ...plan.steps.flatMap((step, i) => stepLines(step, i, w)),
    ...plan.residue.map((residue) => residueLine(residue, w)),
    `${w.time(plan.seconds)}, ${result.tools}: ${plan.tools.length}, ${result.changes}: ${plan.toolChanges}; ${planVerdict(w, plan).text}`,
  ];
}
