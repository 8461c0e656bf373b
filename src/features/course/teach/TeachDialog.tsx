import { Suspense, useEffect, useRef, useState } from "react";
import { answerOf } from "../../../course/judge/answer.ts";
import type { Answer } from "../../../course/judge/judgement.ts";
import { shownLanguageOf, inScreenLanguage } from "../../../course/words.ts";
import { lessonLanguageOf, type Language } from "../../../i18n/languages.ts";
import { formOfTask, sizesOfBoth, textOfTask } from "../../../course/made/form-of-task.ts";
import { formWithSign, type TaskForm } from "../../../course/made/task-form.ts";
import { targetPartOfForm, proposedTask } from "../../../course/made/task-from-form.ts";
import type { Task } from "../../../course/task.ts";
import { targetPart } from "../../../course/target-part.ts";
import { Message } from "../../../app/base/Message.tsx";
import { openContent } from "../../../app/document/store.ts";
import { decimalSign } from "../../../i18n/number.ts";
import { usualTable } from "../../../program/tools/cutting-table.ts";
import { fingerprint } from "../../../app/records/difference.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { keptForm, keyOfTask, keyOfWork } from "../../../app/records/course/kept-form.ts";
import { sizeChoices } from "./size-choices.ts";
import { TeachForm, type InitialForm } from "./TeachForm.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import "./set.css";
import "./teach.css";

/** Source of the form: the program of a work, or a kept task. */
export type TeachSource = { readonly text: string; readonly work: string } | { readonly task: Task };

/** Whether a program makes a part, and the first block that mills; null if it only turns. */
const makesPart = ({ run }: Answer): boolean => run.blank.length > 0 && run.steps.length > 0;
const milledFrom = ({ run }: Answer): number | null => run.plane.find(({ kind }) => kind !== "rapid")?.block ?? null;

/** The material of the open work, if it is on the default list. */
function openMaterial(): TaskForm["material"] {
  const open = openContent()?.material;
  return usualTable.materials.find(({ id }) => id === open)?.id ?? null;
}

function initialFormOf(source: TeachSource, screen: Language): InitialForm | null {
  const base = "task" in source ? source.task : null,
    text = "task" in source ? textOfTask(source.task) : source.text;
  if (text === null) return null;
  const answer = answerOf(text),
    isPart = makesPart(answer),
    firstMilledBlock = milledFrom(answer);
  if (!isPart && firstMilledBlock === null && !base) return null;
  const storageKey = "task" in source ? keyOfTask(source.task.id) : keyOfWork(source.work),
    programFingerprint = fingerprint(text);
  const language = (base && shownLanguageOf(base.words, screen)) ?? lessonLanguageOf(screen),
    kept = keptForm(storageKey);
  const only: Partial<TaskForm> = isPart ? {} : { kind: "predict", start: "program" };
  const form = kept?.form ?? {
    ...(base ? formOfTask(base, text, answer, language) : { ...proposedTask(answer), material: openMaterial() }),
    ...only,
  };
  const sizes = sizesOfBoth(form.sizes, sizeChoices(targetPart(targetPartOfForm(form))));
  return {
    text,
    answer,
    base,
    storageKey,
    programFingerprint,
    language,
    isPart,
    firstMilledBlock,
    initial: kept ? form : formWithSign({ ...form, sizes }, decimalSign(screen)),
    filledFingerprint: kept?.print ?? programFingerprint,
  };
}

/** Runs the program once the dialog is painted; null until then, "none" if it makes no task. */
function useInitialForm(source: TeachSource): InitialForm | "none" | null {
  const [begun, begin] = useState<InitialForm | "none" | null>(null);
  const [first] = useState(source);
  useEffect(() => {
    const timer = setTimeout(() => begin(initialFormOf(first, useSettings.getState().language) ?? "none"));
    return () => clearTimeout(timer);
  }, [first]);
  return begun;
}

/**
 * The form that makes a task from a program, or changes one: filled in, checked at each keystroke, tried and shared.
 */
export function TeachDialog({ done, ...source }: TeachSource & { readonly done: () => void }) {
  const t = useTexts("course-teach");
  const screen = useSettings((s) => s.language);
  const begun = useInitialForm(source);
  const dialog = useRef<HTMLDialogElement>(null);
  const name = "task" in source ? (inScreenLanguage(source.task.words, screen)?.title ?? source.task.id) : null;
  const title = name === null ? t.title : t.titleOf(name);
  const working = (
    <p role="status" className="soft">
      {t.working}
    </p>
  );
  return (
    <ModalDialog ref={dialog} className="teach" title={title} done={done}>
      {/* The form loads texts of its own, while the dialog stays open. */}
      <Suspense fallback={working}>
        {!begun && working}
        {begun === "none" && <Message tone="warning">{t.noPart}</Message>}
        {begun && begun !== "none" && <TeachForm {...begun} done={() => dialog.current?.close()} />}
      </Suspense>
    </ModalDialog>
  );
}
