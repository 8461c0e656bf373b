import { useDeferredValue, useEffect, useMemo, useRef, useState } from "react";
import { answerOf } from "../../../course/judge/answer.ts";
import { judge } from "../../../course/judge/judge.ts";
import type { Answer } from "../../../course/judge/judgement.ts";
import { partOfMade, programOfMade, proposedTask, taskOfMade, type MadeTask } from "../../../course/made/made-task.ts";
import { Icon } from "../../Icon.tsx";
import { fingerprint } from "../../saving/difference.ts";
import { useSettings } from "../../settings/settings.ts";
import { useModal } from "../../use-modal.ts";
import { WorkshopDrawing } from "../drawing/WorkshopDrawing.tsx";
import { wantedPart } from "../../../course/wanted-part.ts";
import { formOfText, keepForm } from "./kept-form.ts";
import { PartFields } from "./PartFields.tsx";
import { RuleFields } from "./RuleFields.tsx";
import { sizeChoices } from "./size-choices.ts";
import { SizeFields } from "./SizeFields.tsx";
import { StartFields } from "./StartFields.tsx";
import { TeachCheck } from "./TeachCheck.tsx";
import { useTeachTexts } from "./use-teach-texts.ts";
import { WordFields } from "./WordFields.tsx";
import "./teach.css";

/** The answer with its form, as it was left or as it is proposed. */
interface Begun {
  readonly answer: Answer;
  readonly first: MadeTask;
}

/** Runs the program once the dialog is painted. */
function useBegun(text: string): Begun | null {
  const [begun, begin] = useState<Begun | null>(null);
  useEffect(() => {
    const timer = setTimeout(() => {
      const answer = answerOf(text);
      const proposed = formOfText(text) ?? proposedTask(answer);
      const sizes = proposed.sizes.length > 0 ? proposed.sizes : sizeChoices(wantedPart(partOfMade(proposed)));
      begin({ answer, first: { ...proposed, sizes } });
    });
    return () => clearTimeout(timer);
  }, [text]);
  return begun;
}

/** The form that makes a task of a program: filled in from it, checked while it is typed, tried and handed out. */
export function TeachDialog({ text, done }: { readonly text: string; readonly done: () => void }) {
  const t = useTeachTexts();
  const begun = useBegun(text);
  const dialog = useRef<HTMLDialogElement>(null);
  useModal(dialog);
  const isPart = begun && begun.answer.run.blank.length > 0 && begun.answer.run.steps.length > 0;
  return (
    <dialog ref={dialog} className="teach" aria-label={t.title}
      onClose={(event) => event.target === dialog.current && !dialog.current.open && done()} onKeyDown={(event) => event.stopPropagation()}
    >
      <div className="teach-head">
        <h2>{t.title}</h2>
        <button type="button" className="button icon plain" aria-label={t.close} onClick={() => dialog.current?.close()}>
          <Icon name="close" />
        </button>
      </div>
      {!begun && <p role="status" className="soft">{t.working}</p>}
      {begun && !isPart && (
        <p className="field-message warning">
          <Icon name="warning" /> {t.noPart}
        </p>
      )}
      {begun && isPart && <Form {...begun} text={text} done={() => dialog.current?.close()} />}
    </dialog>
  );
}

function Form({ answer, first, text, done }: Begun & { readonly text: string; readonly done: () => void }) {
  const t = useTeachTexts();
  const language = useSettings((s) => s.language);
  const [made, set] = useState(first);
  const change = (some: Partial<MadeTask>) => {
    const next = { ...made, ...some };
    set(next);
    keepForm(text, next);
  };
  const settled = useDeferredValue(made);
  const mark = useMemo(() => fingerprint(text).split(" ").at(1) ?? "", [text]);
  const task = useMemo(() => taskOfMade(settled, answer, language, mark), [settled, answer, language, mark]);
  const judged = useMemo(() => ("length" in task ? null : judge(task, answer)), [task, answer]);
  const begins = useMemo(() => (settled.start === "program" ? programOfMade(settled, answer).join("\n") : null), [settled, answer]);
  const isIdle = useMemo(() => begins !== null && !("length" in task) && judge(task, answerOf(begins)).passed, [begins, task]);
  const drawn = useMemo(() => ({
    id: "length" in task ? mark : task.id,
    part: partOfMade(settled),
    sizes: settled.sizes.filter(({ on }) => on).map(({ upper, lower, kind, at, nominal }) => ({
      kind,
      at,
      nominal,
      upper: Number(upper.replace(",", ".")) || 0,
      lower: Number(lower.replace(",", ".")) || 0,
    })),
    rules: "length" in task ? {} : task.rules,
    words: { [language]: { title: settled.words.title || t.part, ask: "", hints: ["", "", ""] as [string, string, string] } },
  }), [task, settled, language, mark, t]);
  return (
    <div className="teach-form">
      <div className="teach-fields">
        <p className="soft">{t.lead}</p>
        <WordFields made={made} change={change} />
        <PartFields made={made} change={change} answer={answer} />
        <SizeFields made={made} change={change} />
        <RuleFields made={made} change={change} />
        <StartFields made={made} change={change} answer={answer} />
      </div>
      <div className="teach-shown">
        <WorkshopDrawing task={drawn} language={language} />
        <TeachCheck task={task} judged={judged} isIdle={isIdle} done={done} />
      </div>
    </div>
  );
}
