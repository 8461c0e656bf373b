import { useEffect, useId, useRef, useState } from "react";
import type { Task, TaskWords } from "../../../course/task.ts";
import { answerKindOf, parsePredictedAnswer } from "../../../course/predicted-answers.ts";
import { changedPlaces, type OtherNumbers } from "../../../course/varied-numbers.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useSelection } from "../../../app/document/selected.ts";
import { useEditor } from "../../../app/document/store.ts";
import { useMedia } from "../../../app/base/use-media.ts";
import { isAnswerKnown, showRun } from "./predict.ts";
import { useTaskProgress } from "../../../app/records/course/progress.ts";
import { AskedAnswer } from "./AskedAnswer.tsx";
import { useTaskView } from "./task-view.ts";
import { setPrediction, taskOfWork } from "../../../app/document/work-task.ts";
import { takeAnswer } from "../../../app/base/until-gone.ts";

const NO_TEXTS: readonly string[] = [];

/** While a question asks for a block number, pointing at a block answers it. */
function usePointedBlock(question: number, asks: boolean): void {
  const isProgram = useEditor((s) => s.program !== null);
  useEffect(() => {
    if (!asks) return undefined;
    const tell = (block: number) => setPrediction(question, String(block));
    if (!isProgram) {
      return useSelection.subscribe(({ line }, before) => {
        if (line && line !== before.line) tell(line.block);
      });
    }
    let stop = () => undefined as void;
    const end = takeAnswer(
      () => import("./block-by-number.ts"),
      ({ subscribePointedBlock }) => (stop = subscribePointedBlock(tell)),
    );
    return () => {
      end();
      stop();
    };
  }, [question, asks, isProgram]);
}

/** If the assignment covers the work: the button that shows the work, to point at the answer. */
function ShowWorkButton({ kind, t }: { readonly kind: ReturnType<typeof answerKindOf>; readonly t: CourseTaskTexts }) {
  const isNarrow = useMedia("narrow");
  const isOpen = useTaskView((v) => v.open);
  if (!isNarrow || !isOpen || (kind !== "place" && kind !== "block")) return null;
  return (
    <button type="button" className="button" onClick={() => useTaskView.setState({ open: false })}>
      <Icon name="up" /> {t.predict.pointAt[kind]}
    </button>
  );
}

/** Most places of other numbers that are named. */
const MOST_PLACES = 4;

/** What is other in the program: "New numbers: Q493, Q494, block 8." */
function renewedText(task: Task, varied: OtherNumbers, t: CourseTaskTexts): string {
  const places = changedPlaces(task, varied).map((place) => (place.startsWith("Q") ? place : t.where.block(place)));
  return t.predict.otherNumbers([...places.slice(0, MOST_PLACES), ...(places.length > MOST_PLACES ? ["…"] : [])]);
}

/** The questions before the run, one at a time. */
export function PredictForm({
  task,
  t,
  words,
  finish,
}: {
  readonly task: Task;
  readonly t: CourseTaskTexts;
  readonly words: TaskWords;
  /** What follows the last answer, where it is not the run. */
  readonly finish?: { readonly label: string; readonly act: () => void };
}) {
  const labelled = useId();
  const told = useEditor((s) => taskOfWork(s)?.told ?? NO_TEXTS);
  const asked = useTaskView((v) => v.question);
  const workTask = useEditor(taskOfWork);
  const { tries } = useTaskProgress(task.id);
  const varied = workTask?.varied;
  const isKnown = isAnswerKnown(task, workTask, tries);
  const predict = task.predict ?? [];
  const order = workTask?.asked ?? predict.map((_, i) => i);
  const position = Math.max(0, order.indexOf(asked));
  const question = order[position] ?? 0;
  const prediction = predict[question];
  usePointedBlock(question, prediction !== undefined && answerKindOf(prediction) === "block");
  const isNarrow = useMedia("narrow");
  const [lacking, lack] = useState<number | null>(null);
  const form = useRef<HTMLFormElement>(null);
  const isTyping = useRef(false);
  // After Enter in a field, the field of the next question gets focus; after a click, the button keeps it.
  useEffect(() => {
    if (!isTyping.current) return;
    isTyping.current = false;
    (form.current?.querySelector<HTMLInputElement>("input:checked") ?? form.current?.querySelector("input"))?.focus();
  }, [question]);
  if (!prediction) return null;
  const isLast = position === order.length - 1;
  const isSaid = (i: number) => {
    const each = predict[i];
    return each !== undefined && parsePredictedAnswer(each, told[i] ?? "") !== null;
  };
  const show = (next: number) => useTaskView.setState({ question: next });
  /** Open answers can be skipped; requesting the run names the first one that is missing. */
  const goOn = () => {
    const open = order.find((i) => !isSaid(i)),
      next = isLast ? open : order[position + 1];
    if (next === undefined) {
      // If the assignment covers the work, the work is shown again with the run and the results.
      if (isNarrow) useTaskView.setState({ open: false });
      if (finish) return finish.act();
      return void showRun(task);
    }
    isTyping.current = next !== question && document.activeElement instanceof HTMLInputElement;
    lack(isLast ? (open ?? null) : null);
    show(next);
  };
  return (
    <form
      ref={form}
      className="task-now task-predict"
      onSubmit={(event) => {
        event.preventDefault();
        goOn();
      }}
    >
      {(isKnown || varied) && (
        <p className="task-renewed small">
          <Icon name={isKnown ? "question" : "compare"} />{" "}
          <span>{isKnown ? t.predict.sameNumbers : varied && renewedText(task, varied, t)}</span>
        </p>
      )}
      <p id={labelled} className="task-question">
        {predict.length > 1 && <span className="soft small">{t.predict.question(question + 1, predict.length)}</span>}
        <b>{words.questions?.[question] ?? t.predict.title}</b>
      </p>
      <AskedAnswer
        key={question}
        prediction={prediction}
        put={(next) => setPrediction(question, next)}
        text={told[question] ?? ""}
        choices={words.choices?.[question] ?? []}
        t={t}
        labelled={labelled}
      />
      <p role="status" className="task-lacks">
        {lacking === question && !isSaid(question) && t.predict.lacks(question + 1, predict.length)}
      </p>
      <div className="task-ways">
        <ShowWorkButton kind={answerKindOf(prediction)} t={t} />
        {position > 0 && (
          <button type="button" className="button" onClick={() => show(order[position - 1] ?? 0)}>
            {t.predict.back}
          </button>
        )}
        <button type="submit" className="button primary">
          {isLast ? (finish?.label ?? t.predict.run) : t.predict.nextQuestion}
        </button>
      </div>
    </form>
  );
}
