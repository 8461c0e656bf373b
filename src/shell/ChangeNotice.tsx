import { useEffect, useEffectEvent, useState } from "react";
import { Icon } from "../app/base/Icon.tsx";
import { NOTICES } from "../app/base/waits.ts";
import { useTexts } from "../app/base/settings/use-texts.ts";
import { workOfDocument } from "../app/document/documents.ts";
import { undoStep } from "../app/document/history.ts";
import { useIsLastStep, type HistoryStep } from "../app/document/steps.ts";
import { useStepWords } from "../app/document/use-step-words.ts";
import type { HistoryTexts } from "../i18n/en/history.ts";

/** Name of the place of a document. */
const placeOf = (document: string, { places }: HistoryTexts): string =>
  workOfDocument(document) === null && Object.hasOwn(places, document)
    ? places[document as keyof typeof places]
    : places.work;

/** Leaves after a while, unless a pointer or the focus is on it: the undo of its own document remains. */
export function ChangeNotice({ step, dismiss }: { readonly step: HistoryStep; readonly dismiss: () => void }) {
  const { undo } = useTexts("first").page;
  const [held, hold] = useState(false);
  const leave = useEffectEvent(dismiss);
  useEffect(() => {
    if (held) return undefined;
    const timer = setTimeout(leave, NOTICES.change);
    return () => clearTimeout(timer);
  }, [step, held]);
  const isLast = useIsLastStep(step);
  const made = useStepWords(isLast ? step : undefined, "past");
  if (!made) return null;
  const { t } = made;
  const said = t.within(placeOf(step.document, t), made.words);
  return (
    <p
      className="notice"
      onPointerEnter={() => hold(true)}
      onPointerLeave={() => hold(false)}
      onFocus={() => hold(true)}
      onBlur={() => hold(false)}
    >
      <Icon name="info" /> <span>{said}</span>
      <button
        type="button"
        className="button"
        aria-label={`${undo} – ${said}`}
        onClick={() => {
          dismiss();
          undoStep(step.document);
        }}
      >
        <Icon name="undo" /> {undo}
      </button>
      <button type="button" className="button icon plain" aria-label={t.dismiss} onClick={dismiss}>
        <Icon name="close" />
      </button>
    </p>
  );
}
