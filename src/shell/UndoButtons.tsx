import { useEffect, useState } from "react";
import { Icon } from "../app/base/Icon.tsx";
import { useTexts } from "../app/base/settings/use-texts.ts";
import { redoStep, undoStep } from "../app/document/history.ts";
import { historyOf, useSteps, type DocumentId, type HistoryStep, type Way } from "../app/document/steps.ts";
import { useNextStepWords } from "../app/document/use-step-words.ts";

/** The step of a document that was undone or redone last, and the side on which it is now the next one. */
function useTakenStep(document: DocumentId | null): { readonly step: HistoryStep; readonly way: Way } | null {
  const [taken, take] = useState<{ readonly step: HistoryStep; readonly way: Way } | null>(null);
  useEffect(
    () =>
      useSteps.subscribe((now, before) => {
        if (now.histories === before.histories) return;
        const [is, was] = [historyOf(document, now), historyOf(document, before)];
        for (const [way, other] of [
          ["future", "past"],
          ["past", "future"],
        ] as const) {
          const step = is[way].at(-1);
          if (step && step === was[other].at(-1)) return take({ step, way });
        }
        if (is !== was) take(null);
      }),
    [document],
  );
  return taken;
}

/** Undo and redo of a document. Their names say what they change; what was undone or redone is announced. */
export function UndoButtons({ document }: { readonly document: DocumentId | null }) {
  const { undo, redo } = useTexts("first").page;
  const canUndo = useSteps((s) => historyOf(document, s).past.length > 0);
  const canRedo = useSteps((s) => historyOf(document, s).future.length > 0);
  const [last, next] = [useNextStepWords(document, "past"), useNextStepWords(document, "future")];
  const taken = useTakenStep(document);
  const made = taken?.way === "future" ? next : last;
  const name = (of: typeof last, label: string) => (of ? of.t.step(label, of.words) : label);
  return (
    <>
      <button
        type="button"
        className="button icon plain"
        aria-label={name(last, undo)}
        title={`${name(last, undo)} (Ctrl+Z)`}
        disabled={!canUndo}
        onClick={() => undoStep(document)}
      >
        <Icon name="undo" />
      </button>
      <button
        type="button"
        className="button icon plain"
        aria-label={name(next, redo)}
        title={`${name(next, redo)} (Ctrl+Y)`}
        disabled={!canRedo}
        onClick={() => redoStep(document)}
      >
        <Icon name="redo" />
      </button>
      <span className="unseen" role="status">
        {made !== null && made.step === taken?.step && made.t.step(made.t.taken[taken.way], made.words)}
      </span>
    </>
  );
}
