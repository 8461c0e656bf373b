import { useDeferredValue, useMemo, useState } from "react";
import { answerOf } from "../../../course/judge/answer.ts";
import { judge } from "../../../course/judge/judge.ts";
import type { Answer } from "../../../course/judge/judgement.ts";
import { editedTask } from "../../../course/made/form-of-task.ts";
import type { LessonLanguage } from "../../../i18n/languages.ts";
import { formWithSign, type TaskForm } from "../../../course/made/task-form.ts";
import { hasAnswerInRun, isComplete, truthsOf } from "../../../course/made/made-questions.ts";
import {
  hasQuestions,
  startProgramOfForm,
  linesOfText,
  targetPartOfForm,
  proposedTask,
  taskOfForm,
  hasTargetPart,
} from "../../../course/made/task-from-form.ts";
import type { Task } from "../../../course/task.ts";
import { targetPart } from "../../../course/target-part.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { decimalSign } from "../../../i18n/number.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { WorkshopDrawing } from "../drawing/WorkshopDrawing.tsx";
import { keepForm, useForms } from "../../../app/records/course/kept-form.ts";
import { PartFields } from "./PartFields.tsx";
import { QuestionFields } from "./QuestionFields.tsx";
import { QuestionPreview } from "./QuestionPreview.tsx";
import { RuleFields } from "./RuleFields.tsx";
import { sizeChoices } from "./size-choices.ts";
import { SizeFields } from "./SizeFields.tsx";
import { StartFields } from "./StartFields.tsx";
import { TeachCheck } from "./TeachCheck.tsx";
import { ThreadFields } from "./ThreadFields.tsx";
import { ToolFields } from "./ToolFields.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { WordFields } from "./WordFields.tsx";

/** The program and its form, as stored or proposed. */
export interface InitialForm {
  readonly text: string;
  readonly answer: Answer;
  readonly initial: TaskForm;
  /** The task being changed; null for a new one. */
  readonly base: Task | null;
  /**
   * Storage key of the form, fingerprint of the program, and fingerprint of the program that the form was filled in
   * from.
   */
  readonly storageKey: string;
  readonly programFingerprint: string;
  readonly filledFingerprint: string;
  readonly language: LessonLanguage;
  readonly isPart: boolean;
  /** The first block that mills. */
  readonly firstMilledBlock: number | null;
}

const NO_QUESTIONS: TaskForm["questions"] = [];
const KINDS = ["make", "fault", "predict", "drawing"] as const;

/** The form with proposals of the changed program; the instructor's decisions stay. */
function withNewProposal(made: TaskForm, answer: Answer, sign: string): TaskForm {
  const fresh = formWithSign(proposedTask(answer), sign),
    { blank, outside, bore, threads } = fresh;
  const rules = Object.fromEntries(
    Object.entries(fresh.rules).map(([name, { text }]) => [
      name,
      { on: made.rules[name as keyof TaskForm["rules"]].on, text },
    ]),
  ) as TaskForm["rules"];
  const prompts = answer.run.operations.length > made.prompts.operation ? made.prompts : fresh.prompts;
  return {
    ...made,
    blank,
    outside,
    bore,
    threads,
    rules,
    prompts,
    sizes: sizeChoices(targetPart(targetPartOfForm(fresh))),
  };
}

/** Numbers, from 1, of the items that match. */
const numbersWhere = <T,>(list: readonly T[], holds: (each: T) => boolean): readonly number[] =>
  list.flatMap((each, i) => (holds(each) ? [i + 1] : []));

/** Results for the current form: the task, the judgement of its answer, and the answers to its questions. */
function useChecked(settled: TaskForm, { answer, base, language, programFingerprint }: InitialForm) {
  const mark = programFingerprint.split(" ").at(1) ?? "";
  const task = useMemo(
    () => (base ? editedTask(base, settled, answer, language) : taskOfForm(settled, answer, language, mark)),
    [base, settled, answer, language, mark],
  );
  const begins = useMemo(() => startProgramOfForm(settled, answer), [settled, answer]);
  const begun = useMemo(() => {
    if (begins === null) return null;
    return linesOfText(begins).join("\n") === linesOfText(answer.text).join("\n") ? answer : answerOf(begins);
  }, [begins, answer]);
  const questions = hasQuestions(settled.kind) ? settled.questions : NO_QUESTIONS;
  const truths = useMemo(
    () => (begun ? truthsOf(questions, hasTargetPart(settled) ? { part: targetPartOfForm(settled) } : {}, begun) : []),
    [questions, settled, begun],
  );
  const foretells = settled.kind === "predict";
  const judged = useMemo(() => ("length" in task || foretells ? null : judge(task, answer)), [task, answer, foretells]);
  const isIdle = useMemo(
    () => begun !== null && !foretells && !("length" in task) && judge(task, begun).passed,
    [begun, foretells, task],
  );
  const lacking = useMemo(
    () => ({
      questions: numbersWhere(questions, (each) => !isComplete(each)),
      truth: numbersWhere(truths, (truth) => begun !== null && truth !== null && !hasAnswerInRun(truth, begun)),
    }),
    [questions, truths, begun],
  );
  return { mark, task, begun, questions, truths, judged, isIdle, lacking };
}

export function TeachForm({ done, ...of }: InitialForm & { readonly done: () => void }) {
  const t = useTexts("course-teach");
  const { answer, base, initial, storageKey, programFingerprint, isPart, firstMilledBlock, text } = of;
  const screen = useSettings((s) => s.language);
  const isKept = useForms((s) => s.trouble !== "notKept");
  const [made, set] = useState(initial);
  const [filledFrom, fill] = useState(of.filledFingerprint);
  const [past, remember] = useState<readonly { readonly made: TaskForm; readonly filledFrom: string }[]>([]);
  const put = (next: TaskForm, from = filledFrom) => {
    set(next);
    fill(from);
    keepForm(storageKey, next, from);
  };
  const step = () => remember((all) => [...all, { made, filledFrom }]);
  const change = (some: Partial<TaskForm>, isStep = false) => {
    if (isStep) step();
    put({ ...made, ...some });
  };
  const settled = useDeferredValue(made);
  const { mark, task, begun, questions, truths, judged, isIdle, lacking } = useChecked(settled, of);
  const drawn = useMemo(
    () => ({
      id: "length" in task ? mark : task.id,
      part: targetPartOfForm(settled),
      ...(settled.material !== null && { material: settled.material }),
      sizes: settled.sizes
        .filter(({ on }) => on)
        .map(({ upper, lower, kind, at, nominal }) => ({
          kind,
          at,
          nominal,
          upper: Number(upper.replace(",", ".")) || 0,
          lower: Number(lower.replace(",", ".")) || 0,
        })),
      rules: "length" in task ? {} : task.rules,
      words: {
        [screen]: { title: settled.words.title || t.part, ask: "", hints: ["", "", ""] as [string, string, string] },
      },
    }),
    [task, settled, screen, mark, t],
  );
  const last = past.at(-1),
    foretells = made.kind === "predict";
  const form = { made, change };
  return (
    <div className="teach-form">
      <div className="teach-fields">
        <p className="soft">
          {!foretells && t.lead} {isKept && t.formStored}
        </p>
        {!isKept && <Message tone="warning">{t.formNotStored}</Message>}
        {firstMilledBlock !== null && (
          <Message tone="warning">{isPart ? t.milled(String(firstMilledBlock)) : t.milledOnly}</Message>
        )}
        {(filledFrom !== programFingerprint || last) && (
          <Message as="div" tone="info" className="teach-changed">
            {filledFrom !== programFingerprint && <span>{t.changedSince}</span>}
            {filledFrom !== programFingerprint && (
              <button
                type="button"
                className="button"
                onClick={() => {
                  step();
                  put(withNewProposal(made, answer, decimalSign(screen)), programFingerprint);
                }}
              >
                {t.proposeAgain}
              </button>
            )}
            {last && (
              <button
                type="button"
                className="button"
                onClick={() => {
                  remember(past.slice(0, -1));
                  put(last.made, last.filledFrom);
                }}
              >
                <Icon name="undo" /> {t.takeBack}
              </button>
            )}
          </Message>
        )}
        <WordFields {...form} kinds={isPart ? KINDS : ["predict"]} language={of.language} />
        {foretells && <StartFields {...form} answer={answer} />}
        {hasQuestions(made.kind) && <QuestionFields {...form} begun={begun} solution={text} truths={truths} />}
        {!foretells && (
          <>
            <PartFields {...form} answer={answer} />
            <ThreadFields {...form} answer={answer} />
            <SizeFields {...form} />
            <ToolFields {...form} answer={answer} />
            <RuleFields {...form} />
            <StartFields {...form} answer={answer} />
          </>
        )}
      </div>
      <div className="teach-shown">
        {!foretells && <WorkshopDrawing task={drawn} language={screen} />}
        {questions.length > 0 && begun && <QuestionPreview questions={questions} truths={truths} begun={begun} />}
        <TeachCheck
          task={task}
          judged={judged}
          isIdle={isIdle}
          foretells={foretells}
          lacking={lacking}
          formKey={storageKey}
          isChange={base !== null}
          done={done}
        />
      </div>
    </div>
  );
}
