import { useEffect, useState } from "react";
import type { HistoryTexts } from "../../i18n/en/history.ts";
import { retryImport } from "../base/parts.ts";
import { fetchTexts } from "../base/settings/loaded-texts.ts";
import { useSettings } from "../base/settings/settings.ts";
import { TYPING } from "../base/waits.ts";
import { historyOf, useSteps, type DocumentId, type HistoryStep, type Way } from "./steps.ts";
import { useEditor } from "./store.ts";
import { takeAnswer } from "../base/until-gone.ts";

/** A step in words: "Q463 3 → 5". */
export interface StepWords {
  readonly step: HistoryStep;
  readonly words: string;
  readonly t: HistoryTexts;
}

/**
 * What a step changes, in words; null until they are made. They follow when typing rests: a long text is compared for
 * them. `way`: the side of its history that the step is the next one of.
 */
export function useStepWords(step: HistoryStep | undefined, way: Way): StepWords | null {
  const language = useSettings((s) => s.language);
  // Typing on changes the text of a step, not the step.
  const program = useEditor((s) => (step?.file === undefined && !step?.parts ? null : s.program));
  const [made, make] = useState<StepWords | null>(null);
  useEffect(() => {
    if (!step) return undefined;
    return takeAnswer(
      () => retryImport(() => Promise.all([import("./words-of-step.ts"), fetchTexts(language, "history")])),
      ([{ wordsOfStep }, t]) => {
        const words = wordsOfStep(step, way, t);
        if (words !== null) make({ step, words, t });
      },
      TYPING.rest,
    );
  }, [step, way, language, program]);
  return step && made?.step === step ? made : null;
}

/** The next step of a document on one side, in words; null for none, and until they are made. */
export const useNextStepWords = (document: DocumentId | null, way: Way): StepWords | null =>
  useStepWords(
    useSteps((s) => historyOf(document, s)[way].at(-1)),
    way,
  );

/** Name of a button that takes the next step of a document: "Undo: Q463 3 → 5", or only "Undo". */
export function useStepName(document: DocumentId | null, way: Way, label: string): string {
  const made = useNextStepWords(document, way);
  return made ? made.t.step(label, made.words) : label;
}
