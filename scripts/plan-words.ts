import { durationText } from "../src/app/base/clock-text.ts";
import { loadTexts } from "../src/i18n/parts.ts";
import {
  missingToolText,
  planActionText,
  planDifferenceText,
  planReasonText,
  planVerdict,
  residueText,
  type PlanWriter,
} from "../src/i18n/plan-text.ts";
import type { NcLanguage } from "../src/nc/nc-languages.ts";
import type { PlanStep, Residue, WorkingPlan } from "../src/planning/working-plan.ts";

/* What `npm run plan` says about a plan on standard error, in the words of the page. */

/** The words of the command in a language. */
export async function planTextsOf(language: NcLanguage): Promise<PlanWriter> {
  const [t, { page }] = [await loadTexts(language, "plan"), await loadTexts(language, "first")];
  return { t, language, time: (seconds) => durationText(page.effect.duration, language, seconds) };
}

function stepLines({ tried, seconds, why, others }: PlanStep, i: number, w: PlanWriter): readonly string[] {
  const { kinds, steps } = w.t;
  const reasons = why.map((reason) => planReasonText(w, reason, tried.action)).join("; ");
  return [
    `${String(i + 1).padStart(2)}. ${kinds[tried.action.kind]}: ${planActionText(w, tried.action)}, ${w.time(seconds)}` +
      (reasons === "" ? "" : ` (${reasons})`),
    ...others.map(
      (other) => `      ${steps.others}: ${planActionText(w, other.tried.action)}: ${planDifferenceText(w, other)}`,
    ),
  ];
}

const residueLine = (residue: Residue, w: PlanWriter): string =>
  [
    `${w.t.left.title}: ${residueText(w, residue)}`,
    ...(residue.missing ? [w.t.left.missing(missingToolText(w, residue.missing))] : []),
  ].join("; ");

/** A plan as lines: its steps with their reasons, what is left, time and verdict. */
export function planLines(plan: WorkingPlan, w: PlanWriter): readonly string[] {
  const { result } = w.t;
  const lines = [
    ...plan.steps.flatMap((step, i) => stepLines(step, i, w)),
    ...plan.residue.map((residue) => residueLine(residue, w)),
    `${w.time(plan.seconds)}, ${result.tools}: ${plan.tools.length}, ${result.changes}: ${plan.toolChanges}; ${planVerdict(w, plan).text}`,
  ];
  // A terminal is searched by its words: their spaces are plain.
  return lines.map((line) => line.replaceAll("\u00a0", " "));
}
