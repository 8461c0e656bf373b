import { Icon } from "../app/base/Icon.tsx";
import { useTexts } from "../app/base/settings/use-texts.ts";
import { redoStep, undoStep } from "../app/document/history.ts";
import { historyOf, useSteps, type DocumentId } from "../app/document/steps.ts";
import { useStepName } from "../app/document/use-step-words.ts";

/** Undo and redo of a document. Their names say what they change. */
export function UndoButtons({ document }: { readonly document: DocumentId | null }) {
  const { undo, redo } = useTexts("first").page;
  const canUndo = useSteps((s) => historyOf(document, s).past.length > 0);
  const canRedo = useSteps((s) => historyOf(document, s).future.length > 0);
  const undoName = useStepName(document, "past", undo);
  const redoName = useStepName(document, "future", redo);
  return (
    <>
      <button
        type="button"
        className="button icon plain"
        aria-label={undoName}
        title={`${undoName} (Ctrl+Z)`}
        disabled={!canUndo}
        onClick={() => undoStep(document)}
      >
        <Icon name="undo" />
      </button>
      <button
        type="button"
        className="button icon plain"
        aria-label={redoName}
        title={`${redoName} (Ctrl+Y)`}
        disabled={!canRedo}
        onClick={() => redoStep(document)}
      >
        <Icon name="redo" />
      </button>
    </>
  );
}
